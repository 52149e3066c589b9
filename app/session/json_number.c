#include "json_number.h"

#include <math.h>
#include <stdio.h>

#include <json.h>

struct json_object *json_number(double value, int digits)
{
    char text[40];
    snprintf(text, sizeof text, "%.*g", digits, value);
    return isfinite(value) ? json_object_new_double_s(value, text) : NULL;
}
