/* Numbers in JSON. json-c prints 17 digits of a double, most of them noise, and what JSON does not know. */
#ifndef FROND_JSON_NUMBER_H
#define FROND_JSON_NUMBER_H

struct json_object;

/* With so many digits, 1..17; NULL, which is written as null, where it is not finite. The caller's. */
struct json_object *json_number(double value, int digits);

#endif
