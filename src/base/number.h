#ifndef WF_BASE_NUMBER_H
#define WF_BASE_NUMBER_H
/* Decimal text to double, the same in every locale. */

/* Given: text from `s` up to `end`, `point` the decimal sign ('.' or ',').
 * Returned: just behind the longest number [+-]digits[.digits][e[+-]digits] at `s` and the value, correctly
 * rounded; NULL when there is no number, or it is beyond the range of a double (1e999, 1e-999).
 * Not numbers: nan, inf, hexadecimal.
 * Method: up to 19 digits with a power of ten within 22 are exact in one operation (Clinger 1990); the rest
 * goes through strtod. */
const char *wf_number_read(const char *s, const char *end, char point, double *value);
#endif
