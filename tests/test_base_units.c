/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities at the door. */
#include "base/units.h"
#include "close.h"
#include <string.h>

static struct wf_units *units;

static int open_units(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    return (int)wf_units_open(&units, &e);
}

static int close_units(void **state)
{
    (void)state;
    wf_units_close(units);
    return 0;
}

static void quantities_become_si(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        enum wf_dimension d;
        double si;
    } good[] = {
        { "10 GPa", WF_DIM_PRESSURE, 1e10 },
        { "10GPa", WF_DIM_PRESSURE, 1e10 },
        { "10.8e10 Pa", WF_DIM_PRESSURE, 10.8e10 },
        { "45 N/mm2", WF_DIM_PRESSURE, 45e6 },
        { "9 mm", WF_DIM_LENGTH, 0.009 },
        { "  9 mm \n", WF_DIM_LENGTH, 0.009 },
        { "2 in", WF_DIM_LENGTH, 0.0508 },
        { "12 \xC2\xB5m", WF_DIM_LENGTH, 12e-6 },
        { "36 km/h", WF_DIM_SPEED, 10 },
        { "36 kmh", WF_DIM_SPEED, 10 },
        { "36 kph", WF_DIM_SPEED, 10 },
        { "10 mph", WF_DIM_SPEED, 4.4704 },
        { "10 knot", WF_DIM_SPEED, 18520.0 / 3600 },
        { "15 m s-1", WF_DIM_SPEED, 15 },
        { "700 kg/m3", WF_DIM_DENSITY, 700 },
        { "700 kg m-3", WF_DIM_DENSITY, 700 },
        { "700 kg/m^3", WF_DIM_DENSITY, 700 },
        { "700 kg/m\xC2\xB3", WF_DIM_DENSITY, 700 },
        { "0.7 g/cm3", WF_DIM_DENSITY, 700 },
        { "0.7 t/m3", WF_DIM_DENSITY, 700 },
        { "30 deg", WF_DIM_ANGLE, 30 * 3.14159265358979323846 / 180 },
        { "30 degrees", WF_DIM_ANGLE, 30 * 3.14159265358979323846 / 180 },
        { "30\xC2\xB0", WF_DIM_ANGLE, 30 * 3.14159265358979323846 / 180 },
        { "0.5 rad", WF_DIM_ANGLE, 0.5 },
        { "15 degC", WF_DIM_TEMPERATURE, 288.15 },
        { "288.15 K", WF_DIM_TEMPERATURE, 288.15 },
        { "0.35", WF_DIM_NONE, 0.35 },
        { "-0.7", WF_DIM_NONE, -0.7 },
        { "12 %", WF_DIM_NONE, 0.12 },
        { "12%", WF_DIM_NONE, 0.12 },
        { "17 m2", WF_DIM_AREA, 17 },
        { "0.2 kg/m2", WF_DIM_MASS_PER_AREA, 0.2 },
        { "2 Hz", WF_DIM_FREQUENCY, 2 },
        { "300 kN m/rad", WF_DIM_ROTATIONAL_STIFFNESS, 3e5 },
        { "300 kNm/rad", WF_DIM_ROTATIONAL_STIFFNESS, 3e5 },
        { "2 kNm/deg", WF_DIM_ROTATIONAL_STIFFNESS, 2e3 * 57.295779513082323 },
        { "3 Nm", WF_DIM_MOMENT, 3 },
        { "3 kNm", WF_DIM_MOMENT, 3e3 },
        { "3 MNm", WF_DIM_MOMENT, 3e6 },
        { "3 kN m", WF_DIM_MOMENT, 3e3 },
        { "1.5e-5 m2/s", WF_DIM_VISCOSITY, 1.5e-5 },
        { "9.81 m/s2", WF_DIM_ACCELERATION, 9.81 },
        { "12 kN", WF_DIM_FORCE, 12e3 },
        { "9 N/((((m))))", WF_DIM_FORCE_PER_LENGTH, 9 },
        { "3 kg\xC2\xB7m^-3", WF_DIM_DENSITY, 3 },
        { "4 cm\xC2\xB2", WF_DIM_AREA, 4e-4 },
        { "90 \xC2\xB0", WF_DIM_ANGLE, 1.5707963267948966 },
        { "5 \xC2\xB5m", WF_DIM_LENGTH, 5e-6 },
        { "5 \xCE\xBCm", WF_DIM_LENGTH, 5e-6 },
        { "15 \xC2\xB0"
          "C",
          WF_DIM_TEMPERATURE, 288.15 },
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        struct wf_err e = { 0 };
        double si = NAN;
        if (wf_quantity_read(units, good[i].text, good[i].d, &si, &e)) fail_msg("%s", e.text);
        assert_close(si, good[i].si, 4e-16);
    }
}

static void mistakes_are_explained(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        enum wf_dimension d;
        const char *why;
    } bad[] = {
        { "6.1", WF_DIM_PRESSURE, "'6.1' has no unit; write for example '6.1 GPa'" },
        { "10 Gpa", WF_DIM_PRESSURE,
          "'10 Gpa': 'Gpa' is not a known unit for a pressure (stress, modulus); use one of: GPa, MPa, Pa, "
          "N/mm2" },
        { "10 pa", WF_DIM_PRESSURE,
          "'10 pa': 'pa' is not a unit of a pressure (stress, modulus); use one of: GPa, MPa, Pa, N/mm2" },
        { "700 m3/kg", WF_DIM_DENSITY,
          "'700 m3/kg': 'm3/kg' is not a unit of a density; use one of: kg/m3, g/cm3" },
        { "9 kg", WF_DIM_LENGTH, "'9 kg': 'kg' is not a unit of a length; use one of: m, cm, mm" },
        { "5 s", WF_DIM_FREQUENCY, "'5 s': 's' is not a unit of a frequency; use one of: Hz, s-1" },
        { "0.35 rad", WF_DIM_NONE, "'0.35 rad': a plain number is expected, without 'rad'" },
        { "0.35 m", WF_DIM_NONE, "'0.35 m': a plain number is expected, without 'm'" },
        { "30", WF_DIM_ANGLE, "'30' has no unit; write for example '30 deg'" },
        { "30 %", WF_DIM_ANGLE, "'30 %': '%' is not a unit of an angle; use one of: deg, rad" },
        { "", WF_DIM_LENGTH, "the value is empty; a length is expected" },
        { "  ", WF_DIM_NONE, "the value is empty; a plain number is expected" },
        { "nan", WF_DIM_NONE, "'nan' is not a number; write for example '0.5'" },
        { ".nan", WF_DIM_NONE, "'.nan' is not a number; write for example '0.5'" },
        { "inf m", WF_DIM_LENGTH, "'inf m' is not a length; write for example '1.5 m'" },
        { "tall", WF_DIM_LENGTH, "'tall' is not a length; write for example '1.5 m'" },
        { "0x10 m", WF_DIM_LENGTH,
          "'0x10 m': 'x10 m' is not a known unit for a length ('1' is not allowed there); use one of: m, cm, "
          "mm" },
        { "1e999 m", WF_DIM_LENGTH, "'1e999 m' is beyond the range of numbers" },
        { "1e306 km", WF_DIM_LENGTH, "'1e306 km' is beyond the range of numbers" },
        { "6,1 GPa", WF_DIM_PRESSURE, "'6,1 GPa' has a comma; write the decimals after a point" },
        { "10 000 kg/m3", WF_DIM_DENSITY,
          "'10 000 kg/m3': '000 kg/m3' is not a known unit for a density ('0' is not allowed there); use one "
          "of: kg/m3, g/cm3" },
        { "10 2GPa", WF_DIM_PRESSURE,
          "'10 2GPa': '2GPa' is not a known unit for a pressure (stress, modulus) ('2' is not allowed "
          "there); use one of: GPa, MPa, Pa, "
          "N/mm2" },
        { "9 m @ 3", WF_DIM_LENGTH,
          "'9 m @ 3': 'm @ 3' is not a known unit for a length ('@' is not allowed there); use one of: m, "
          "cm, mm" },
        { "9 lg(re 1 m)", WF_DIM_LENGTH,
          "'9 lg(re 1 m)': 'lg(re 1 m)' is not a known unit for a length ('(' is not allowed there); use one "
          "of: m, cm, mm" },
        { "9 m/", WF_DIM_LENGTH,
          "'9 m/': 'm/' is not a known unit for a length (it is not complete); use one of: m, cm, mm" },
        { "9 N/(((((m)))))", WF_DIM_FORCE_PER_LENGTH,
          "'9 N/(((((m)))))': 'N/(((((m)))))' is not a known unit for a force per length ('(' is not allowed "
          "there); use "
          "one of: N/m, kN/m" },
        { "9 \xE2\x82\xAC", WF_DIM_LENGTH,
          "'9 \xE2\x82\xAC': '\xE2\x82\xAC' is not a known unit for a length ('\xE2\x82\xAC' is not allowed "
          "there); use "
          "one of: m, cm, mm" },
        { "9 m m m m m m m m m m m m m m m m m m m m m m m m m m m m m m m m", WF_DIM_LENGTH,
          "'9 m m m m m m m m m m m m m m m m m m m m m m m m m m m m m m m m': 'm m m m m m m m m m m m m m "
          "m m m m m m "
          "m m m m m m m m m m m m' is not a known unit for a length (it is longer than 60 bytes); use one "
          "of: m, cm, mm" },
        { "9 m m", WF_DIM_LENGTH, "'9 m m': 'm m' is not a unit of a length; use one of: m, cm, mm" },
        { "9 mm extra", WF_DIM_LENGTH,
          "'9 mm extra': 'mm extra' is not a known unit for a length; use one of: m, cm, mm" },
        { "1.2.3 m", WF_DIM_LENGTH,
          "'1.2.3 m': '.3 m' is not a known unit for a length ('.' is not allowed there); use one of: m, cm, "
          "mm" },
        { "12345678901234567890123456789012345678901234567890123456789012345678901234567890123456789012345678"
          " m",
          WF_DIM_LENGTH, "'1234567890123456789012345678901234567890...' is too long for a quantity" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct wf_err e = { 0 };
        double si = 77;
        assert_int_equal(wf_quantity_read(units, bad[i].text, bad[i].d, &si, &e), WF_EINPUT);
        assert_string_equal(e.text, bad[i].why);
        assert_close(si, 77, 0);
    }
}

static void si_is_printed_in_a_unit(void **state)
{
    (void)state;
    char buf[64];
    assert_string_equal(wf_quantity_print(units, 1e10, WF_DIM_PRESSURE, "GPa", buf, sizeof buf), "10 GPa");
    assert_string_equal(wf_quantity_print(units, 0.009, WF_DIM_LENGTH, "mm", buf, sizeof buf), "9 mm");
    assert_string_equal(wf_quantity_print(units, 288.15, WF_DIM_TEMPERATURE, "degC", buf, sizeof buf),
                        "15 degC");
    assert_string_equal(wf_quantity_print(units, 0.35, WF_DIM_NONE, "", buf, sizeof buf), "0.35");
    assert_string_equal(wf_quantity_print(units, 0.12, WF_DIM_NONE, "%", buf, sizeof buf), "12 %");
    assert_string_equal(wf_quantity_print(units, 2, WF_DIM_LENGTH, "kg", buf, sizeof buf), "2 m");
    assert_string_equal(wf_quantity_print(units, 2, WF_DIM_LENGTH, "", buf, sizeof buf), "2 m");
}

/* Every dimension's offered units are read back as that dimension. */
static void offered_units_are_accepted(void **state)
{
    (void)state;
    for (int d = 0; d < WF_DIM_COUNT; d++) {
        const struct wf_dimension_row *r = wf_dimension_row((enum wf_dimension)d);
        assert_true(strlen(r->name) > 0);
        for (const char *u = r->units; *u;) {
            char text[64];
            int n = (int)strcspn(u, ",");
            snprintf(text, sizeof text, "1.5 %.*s", n, u);
            struct wf_err e = { 0 };
            double si;
            if (wf_quantity_read(units, text, (enum wf_dimension)d, &si, &e)) fail_msg("%s", e.text);
            u += n;
            u += strspn(u, ", ");
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quantities_become_si),
        cmocka_unit_test(mistakes_are_explained),
        cmocka_unit_test(si_is_printed_in_a_unit),
        cmocka_unit_test(offered_units_are_accepted),
    };
    return cmocka_run_group_tests(tests, open_units, close_units);
}
