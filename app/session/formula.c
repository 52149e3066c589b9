#include "formula.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <muParserDLL.h>

static const double PI = 3.14159265358979323846;
static const char ALLOWED[] = "x, y, pi, numbers, + - * / ^ ( ), < <= > >= == != && || ?:, and functions like sin(x)";

struct formula {
    muParserHandle_t parser;
    double x, y;
};

/* muParser prints to the terminal where it has no handler; errors are asked for instead. */
static void quiet(muParserHandle_t parser)
{
    (void)parser;
}

static double modulo(double x, double y)
{
    return x - y * floor(x / y);
}

static double clamp(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

static double smoothstep(double low, double high, double x)
{
    double t = clamp((x - low) / (high - low), 0, 1);
    return t * t * (3 - 2 * t);
}

/* muParser's error codes (EErrorCodes in its ParserError.h; its C header does not name them) in the curator's words. */
static const char *meaning(int code)
{
    switch (code) {
    case 0:
        return "an operator that does not fit there";
    case 1:
        return "unknown";
    case 2:
        return "the expression ends too early";
    case 3:
        return "a comma that does not fit there";
    case 4:
        return "a comma or bracket that does not fit there";
    case 5:
        return "a value where an operator should be";
    case 6:
        return "a name where an operator should be";
    case 7:
        return "a bracket that does not fit there";
    case 8:
    case 9:
        return "a function that does not fit there";
    case 10:
    case 16:
    case 17:
        return "text in quotes";
    case 11:
        return "a bracket is not closed";
    case 14:
        return "too many values for the function";
    case 15:
        return "too few values for the function";
    case 25:
        return "empty";
    case 34:
    case 35:
        return "? and : do not pair up";
    default:
        return "not an expression";
    }
}

static bool fail(struct formula_problem *problem, int at, const char *what, const char *token, const char *allowed)
{
    enum { SHOWN = 30 };
    problem->at = at;
    int length = (int)strnlen(token, SHOWN);
    while (length > 0 && ((unsigned char)token[length] & 0xc0) == 0x80) {
        length--;
    }
    while (length > 0 && token[length - 1] == ' ') {
        length--;
    }
    if (length) {
        snprintf(problem->text, sizeof problem->text, "%s: '%.*s'; %s", what, length, token, allowed);
    } else {
        snprintf(problem->text, sizeof problem->text, "%s; %s", what, allowed);
    }
    return false;
}

/* The 1-based character at a byte of an expression. */
static int character_at(const char *expression, int byte)
{
    int character = 1;
    for (int i = 0; i < byte && expression[i]; i++) {
        character += ((unsigned char)expression[i] & 0xc0) != 0x80;
    }
    return character;
}

/* muParser would take `x = 3` for an assignment. */
static int find_assignment(const char *expression)
{
    for (int i = 0; expression[i]; i++) {
        if (expression[i] == '=') {
            bool compares = i > 0 && strchr("<>!", expression[i - 1]);
            if (!compares && expression[i + 1] != '=') {
                return i;
            }
            i += expression[i + 1] == '=';
        }
    }
    return -1;
}

static bool check(struct formula *formula, const char *expression, struct formula_problem *problem)
{
    int assignment = find_assignment(expression);
    if (assignment >= 0) {
        return fail(problem, character_at(expression, assignment), "a single =", "", "== compares");
    }
    mupSetExpr(formula->parser, expression);
    int results = 0;
    mupEvalMulti(formula->parser, &results);
    if (mupError(formula->parser)) {
        int byte = mupGetErrorPos(formula->parser);
        int code = mupGetErrorCode(formula->parser);
        bool named = code != 2 && code != 11 && code != 25 && code != 34 && code != 35;
        const char *token = named ? mupGetErrorToken(formula->parser) : "";
        return fail(problem, byte < 0 ? 0 : character_at(expression, byte), meaning(code), token, ALLOWED);
    }
    if (results != 1) {
        return fail(problem, 0, "several values", "", "one expression gives one value");
    }
    return true;
}

struct formula *formula_create(const char *expression, struct formula_problem *problem)
{
    if (strlen(expression) > FORMULA_LENGTH_MAX) {
        fail(problem, 0, "too long", "", "an expression is at most 1000 bytes");
        return NULL;
    }
    struct formula *formula = calloc(1, sizeof *formula);
    if (formula) {
        formula->x = formula->y = 0.5;
        formula->parser = mupCreate(muBASETYPE_FLOAT);
    }
    if (!formula || !formula->parser) {
        fail(problem, 0, "memory is short", "", "close something else");
        formula_destroy(formula);
        return NULL;
    }
    mupSetErrorHandler(formula->parser, quiet);
    mupDefineVar(formula->parser, "x", &formula->x);
    mupDefineVar(formula->parser, "y", &formula->y);
    mupDefineConst(formula->parser, "pi", PI);
    mupDefineFun2(formula->parser, "atan2", atan2, 1);
    mupDefineFun2(formula->parser, "hypot", hypot, 1);
    mupDefineFun1(formula->parser, "floor", floor, 1);
    mupDefineFun1(formula->parser, "ceil", ceil, 1);
    mupDefineFun2(formula->parser, "mod", modulo, 1);
    mupDefineFun3(formula->parser, "clamp", clamp, 1);
    mupDefineFun3(formula->parser, "smoothstep", smoothstep, 1);
    if (!check(formula, expression, problem)) {
        formula_destroy(formula);
        return NULL;
    }
    return formula;
}

void formula_destroy(struct formula *formula)
{
    if (formula && formula->parser) {
        mupRelease(formula->parser);
    }
    free(formula);
}

bool formula_sample(struct formula *formula, int width, int height, float *values, struct formula_problem *problem)
{
    for (int row = 0; row < height; row++) {
        formula->y = (row + 0.5) / height;
        for (int column = 0; column < width; column++) {
            formula->x = (column + 0.5) / width;
            double value = mupEval(formula->parser);
            if (!(fabs(value) <= FORMULA_VALUE_MAX)) {
                problem->at = 0;
                char found[40] = "not a number";
                if (!isnan(value)) {
                    snprintf(found, sizeof found, "%g", value);
                }
                snprintf(problem->text, sizeof problem->text, "is %s at x = %.4g, y = %.4g; %g to %g everywhere", found,
                         formula->x, formula->y, -FORMULA_VALUE_MAX, FORMULA_VALUE_MAX);
                return false;
            }
            values[(size_t)row * (size_t)width + (size_t)column] =
                (float)(nearbyint(value * FORMULA_STEPS) / FORMULA_STEPS);
        }
    }
    return true;
}
