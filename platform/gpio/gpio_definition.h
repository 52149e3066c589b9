/* Whether a definition of GPIO lines can hold, and its lines as a bank wants them. Private to source_gpio. */
#ifndef FROND_GPIO_DEFINITION_H
#define FROND_GPIO_DEFINITION_H

#include "gpio_bank.h"

/* What it says that is wrong: a line. */
bool gpio_definition_check(const struct source_gpio_def *def, struct device_error *error);
/* The lines of a definition that holds, in this order: buttons, A and B of each encoder, lamps. */
void gpio_definition_lines(const struct source_gpio_def *def, struct gpio_bank *bank);

#endif
