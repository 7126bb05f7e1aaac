#!/usr/bin/env python3
"""Makes published_figures.csv from tables of published figures: numbers, units, places and tolerances.

    make_published_figures.py FOLDER > published_figures.csv

FOLDER holds targets-bierwisch.csv, targets-hu.csv and targets-kottlan.csv. A row belongs to the experiment of
`diefill lab` that measures it (EXPERIMENTS), or to none yet. Where the source states a trend instead of a number,
CRITERIA gives the number that is measured in its place and the range in which the trend holds.
"""
import csv
import math
import re
import sys

SOURCES = (("bierwisch", "Bierwisch 2009"), ("hu", "Hu 2024"), ("kottlan", "Kottlan 2018"))

# Experiment of `diefill lab`: the rows that it measures, as regular expressions.
EXPERIMENTS = {
    "closed_forms": "V(0[1-9]|[12][0-9])",
    "clump_collision": "B0[1-4]",
    "bulk_formation": "K(0[1-9]|10)",
    "slit_flow": "F0[1-5]",
    "shoe_discharge": "S0[1-9]",
    "packing_scatter": "Q(0[1-9]|1[0-6])",
    "fill_height": "G0[1-5]",
    "slit_fields": "L0[1-3]",
    "moving_shoe": "E0[6-9]",
    "long_shoe": "E1[01]",
    "hopper_design": "HOP-design-(half|minimum)",
    "shear_tester": "L(100|220)-pred-(tau_pre|tau_0|k_YL)|SCR-invalid",
    "wedge_hopper": "HOP-1",
    "packing": "PACK-1",
    "confined_compression": "L(100|220)-pred-(beta|k_load|k_unload|sigma_tens)|SCR-(order|tens2)|PACK-2",
    "lactose_screening": "SCR-(phi0|beta|phif|kload|kunload|tens|neg)",
    "lactose_large_range": "ERR-9-(no|with)-(beta|k_load|k_unload|sigma_tens)|CAL-err",
    "lh100_range": "(L100-range-(min|max)|ERR-19-(no|with))-(beta|k_load|k_unload|sigma_tens)",
    "lh220_range": "(L220-range-(min|max)|ERR-20-(no|with))-(beta|k_load|k_unload|sigma_tens)",
    "lactose_shear_screening": "SCR-(taupre|tau0|kYL)",
    "lactose_shear_range": "ERR-9-(no|with)-(tau_pre|tau_0|k_YL)|CAL-mus",
    "lh100_shear_range": "(L100-range-(min|max)|ERR-19-(no|with))-(tau_pre|tau_0|k_YL)",
    "lh220_shear_range": "(L220-range-(min|max)|ERR-20-(no|with))-(tau_pre|tau_0|k_YL)",
    "rolling_model": "ROLL-1",
    "angle_of_repose": "R(0[3-9]|10|11)",
    "heap_sizes": "R12",
    "mean_fractions": "N(0[1-9]|1[0-2])",
    "uniaxial_compression": "UNI-[1-3]",
    "mono_disperse_beds": "BED-(0|08|drop|coord|M1|M1l|M3)|CDT-(016|drop|M1)",
    "bi_disperse_beds": "BI-(M1|mono|seg)",
    "log_normal_beds": "LN-02-((rho|z)-(0|80)|M1)|LN-002-M1rho|LN-(gamma|trend)",
    "log_normal_scaling": "LN-002-M1z[24]",
    "heap_on_plate": "AOR-(02|range|M1|M1b|M3)",
    "critical_step": "BOX-theory",
    "vertical_mixer": "MIX-(peak|shift|lin|M[123]|liq|jkr1|jkr23|Dd)",
    "wall_friction": "W0[12]",
    "ring_levels": "M0[12]",
    "ring_maps": "M07|M23",
    "ring_transient": "M09|M10",
    "ring_displacement": "M11",
    "wire_sawing": "Z0[1-9]",
}
# Rows that a family of experiments with a table of its own measures.
FAMILIES = {
    "comparisons": "H0[125]|M(03|06|08|1[2-9]|2[0124])",
    "flow": "D(0[1-9]|1[0-5])|E0[1-5]",
}

FOLLOWS_THE_CURVE = ("residual against the measured curve, or a thousandth of the largest deviation of a point over "
                     "10 % or 2 mm2, the larger", "1", None, 1e-3)

# Row: label, unit, least and largest value that agree with the trend.
CRITERIA = {
    "V01": ("minimum of elastic+cohesive force, within 1e-6 of -3/2 pi w R_eff", "N",
            -1.5 * math.pi * 0.01 * 3.92e-5 * (1 + 1e-6), -1.5 * math.pi * 0.01 * 3.92e-5 * (1 - 1e-6)),
    "V15": ("v_z(0,z), within 0.5 % of the equation's -0.27703", "m/s", -0.27703 * 1.005, -0.27703 * 0.995),
    "V16": ("v_z(0,z), within 0.5 % of the equation's -0.17900", "m/s", -0.179 * 1.005, -0.179 * 0.995),
    "V17": ("order of the error, smooth fraction and velocity", "1", 0.95, None),
    "V18": ("largest difference of A from the identity", "1", None, 1e-14),
    "B01": ("largest difference of contact energy density over sizes, over its peak", "1", None, 1e-6),
    "B02": ("the same, gamma_n fixed", "1", 0.02, None),
    "B03": ("the same, kappa_t fixed", "1", 0.02, None),
    "B04": ("the same, w fixed", "1", 0.02, None),
    "K07": ("largest difference over sizes, in tolerances (h/d 3 %, contacts 0.1, fraction 0.005)", "1", None, 1),
    "K08": ("share of statements that hold, gamma_n fixed: same h/d (3 %), more contacts (0.05) and a higher fraction "
            "(0.001) with larger d", "1", 1, None),
    "K09": ("share of statements that hold, kappa_t fixed: same h/d (3 %), more contacts and a higher fraction with "
            "larger d, by more than with gamma_n fixed", "1", 1, None),
    "K10": ("share of statements that hold, w fixed: larger h/d of small grains, more contacts and a higher fraction "
            "with larger d", "1", 1, None),
    "F01": ("larger of the offset's difference from 1.4 d over 0.3 d and the spread over 5 %", "1", None, 1),
    "F02": ("larger of the offset's difference from 1.4 d over 0.3 d and the spread over 5 %", "1", None, 1),
    "F03": ("larger of the offset's difference from 1.4 d over 0.3 d and the spread over 5 %", "1", None, 1),
    "F04": ("rate with w fixed over that with w in proportion to d, same size and slit, least of the sizes", "1", 1.0,
            None),
    "Z04": ("largest difference of the viscosity over shear rates from its mean, over the mean", "1", None, 0.05),
    "Z05": ("R^2 of a line through the velocity across the gap", "1", 0.99, None),
    "Z08": ("share of the force within 30 um of the groove's centre, semi-contact over non-contact", "1", 2, None),
    "Z09": ("normal stress beyond 100 um, semi-contact over non-contact", "1", 0.5, 2),
    "S01": FOLLOWS_THE_CURVE,
    "S02": FOLLOWS_THE_CURVE,
    "S03": FOLLOWS_THE_CURVE,
    "S04": FOLLOWS_THE_CURVE,
    "S05": ("area over that of the measured curve, at the speed farthest from agreement", "1", 0.95, 1.2),
    "S06": ("area over that of the measured curve, at the speed farthest from agreement", "1", 0.95, 1.2),
    "S07": ("area over that of the measured curve, at the speed farthest from agreement", "1", 0.95, 1.2),
    "S08": ("area over that of the measured curve, at the speed farthest from agreement", "1", 0.95, 1.2),
    "S09": ("share of speeds at which D2 lies between measured curve and A2", "1", 1, None),
    "G01": ("discharge, 10 mm of fill over 41 mm", "1", 1.03, None),
    "G02": ("discharge, 10 mm of fill over 41 mm", "1", 1.03, None),
    "G03": ("discharge, 10 mm of fill over 41 mm", "1", 0.97, 1.1),
    "G04": ("discharge, 10 mm of fill over 41 mm", "1", 0.97, 1.03),
    "G05": ("share of statements that hold: discharge at 10 mm of fill above that at 19 and at 41 mm by 3 %, these "
            "within 3 %", "1", 1, None),
    "R09": ("drift of the surface from 2 to 4 s after the draw", "d/s", 0.5, None),
    "R10": ("drift of the surface from 2 to 4 s after the draw", "d/s", 0.5, None),
    "R11": ("share of statements that hold: theta_O of D1 above that of D2 by 12 deg, theta_H within 5 deg", "1", 1,
            None),
    "R12": ("share of statements that hold: longer toe and flatter peak with larger d", "1", 1, None),
    "D05": ("bend of the isoline v_z = -0.1 m/s near the slit, DEM over KM", "1", None, 0.5),
    "D11": ("error of v_x, CKM over KM", "1", None, 0.5),
    "D13": ("spread of v_z and v_x over sqrt(gD) over set-ups, over the peak", "1", None, 0.05),
    "D14": ("mean v_z over sqrt(gD) above 3 D, larger of set-ups 2 and 5 over mean of 1, 3 and 4", "1", None, 0.95),
    "D15": ("solid fraction above the slit, largest of set-ups 2 and 4 less smallest of 1, 3 and 5", "1", None, 0),
    "L02": ("slow powder behind the slit, C1 and D1 over A1 and B1", "1", 1, None),
    "L03": ("scatter of v/v_s over cells of 2 d, beyond 1.5 D", "1", None, 0.05),
    "HOP-design-half": ("half angle, from the predicted shear test", "deg", 28, 42),
    "HOP-design-minimum": ("slot width, from the predicted shear test", "m", 0.05, 0.2),
    "HOP-1": ("share of the powder that leaves, larger of slot and double slot", "%", None, 1),
    "SCR-invalid": ("pre-shear stress over the yield locus at its normal stress, larger of LH100 and LH220", "1", 1,
                    None),
    "PACK-1": ("drop of the fraction from the largest to the smallest spheres, clusters less plain falling", "1", 0,
               None),
    "PACK-2": ("fraction of LH100 after pressing over the measured one, 0.50", "1", 1, None),
    "SCR-taupre": ("smallest of the effects of A_H, -r, f1 and f2 on tau_pre, over the largest other", "1", 1, None),
    "SCR-tau0": ("smallest size of the effects of A_H, r, f1 and f2 on tau_0, over the largest other", "1", 1, None),
    "SCR-kYL": ("share of A_H, -r, f1 and f2 with a falling effect on k_YL", "1", 1, None),
    "CAL-mus": ("effect of mu_s, 0.5 to 1.2, on tau_pre", "kPa", None, 0),
    "ROLL-1": ("kinetic energy of a packed bed, Luding's spring with mu_r = 1 over none", "1", 10, None),
    "SCR-phi0": ("smaller of the effects of r and -A_H on the initial fraction, over the largest other", "1", 1,
                 None),
    "SCR-beta": ("correlation of the effects on beta and on the initial fraction, but mu_s", "1", None, -0.5),
    "SCR-phif": ("smaller of the effects of mu_s and Y on the final fraction, over the largest other", "1", 1, None),
    "SCR-kload": ("share of Y, f1, f3, phi_f and mu_s with the published sign of their effect on k_load", "1", 1,
                  None),
    "SCR-kunload": ("share of Y, f1, phi_f and mu_s with the published sign of their effect on k_unload", "1", 1,
                    None),
    "SCR-tens": ("share of runs stronger than the measured LH220", "1", 0.5, None),
    "SCR-neg": ("largest effect of e, f5, f3 and f4 over the largest of all, any metric", "1", None, 0.3),
    "CAL-err": ("error without over error with interactions, smallest of four metrics", "1", 1.5, None),
    "SCR-tens2": ("way from the peak of the pull to a tenth of it, smaller of LH100 and LH220", "d", 0.1, None),
    "SCR-order": ("k_unload over k_load, smaller of LH100 and LH220", "1", 1, None),
    "H01": ("mean level of A1 less the lowest other one, larger of both speeds", "mm", None, 0),
    "H02": ("mean level of A2 less the highest other one, smaller of both speeds", "mm", 0, None),
    "H05": ("mean level at 0.2 m/s less that at 0.5 m/s", "mm", 0, None),
    "M06": ("1st harmonic of the fraction over azimuth, away from 180 deg", "1", 0.003, None),
    "M13": ("scatter of the fraction in the map, 0.022 over 0.09 m/s", "1", 1, None),
    "M14": ("largest difference of the fraction's scatter over speeds", "1", None, 0.003),
    "M15": ("change of the mean fraction", "1", None, 0.005),
    "M16": ("2nd harmonic of the fraction, dense at 90 and 270 deg", "1", 0.003, None),
    "M17": ("change of mean fraction and harmonics", "1", None, 0.002),
    "M18": ("2nd harmonic of the fraction, dense at 0 and 180 deg", "1", 0.003, None),
    "M19": ("2nd harmonic of the fraction, dense at 0 and 180 deg", "1", 0.003, None),
    "M20": ("change of mean fraction and harmonics", "1", None, 0.002),
    "M21": ("rise of the mean fraction at 8 Hz", "1", 0.002, None),
    "M22": ("1st harmonic of the fraction over azimuth", "1", None, 0.003),
    "M24": ("fraction of the lower part less that after a passage", "1", 0.003, None),
    "UNI-1": ("mean difference of stress from l = 1, M1, strain 0.03 to 0.1", "1", None, 0.1),
    "UNI-2": ("stress at strain 0.1, M2 over M1, over l^1.5", "1", 1 / 1.5, 1.5),
    "UNI-3": ("stress at strain 0.1, M3 over M1, over l", "1", 1 / 1.4, 1.4),
    "BED-coord": ("share of steps in mu_r at which contacts fall and the bed grows", "1", 1, None),
    "BED-M1l": ("larger deviation over l, mu_r = 0 and 0.8", "%", None, 1),
    "BED-M3": ("density lost with M3, mu_r = 0", "%", 10, None),
    "BI-mono": ("density over that of small spheres alone, mu_r = 0", "1", 1, None),
    "BI-seg": ("largest difference of a slice's mass share of small spheres from a half", "1", None, 0.05),
    "LN-02-M1": ("larger of density difference over 1 % and contact difference over 0.08, l = 2 and 4", "1", None, 1),
    "LN-gamma": ("share of widths at which larger gamma gives less density and fewer contacts", "1", 1, None),
    "LN-trend": ("share of steps in s_d/m_d at which density rises and contacts fall", "1", 1, None),
    "AOR-range": ("share of statements that hold: classes at mu_r = 0 and 0.8 within 3 deg, steeper with mu_r", "1", 1,
                  None),
    "AOR-M1b": ("deviation of M1 at mu_r = 0 less that at 0.2", "%", 0, None),
    "AOR-M3": ("angle with M3 less that with M1", "deg", 5, None),
    "BOX-theory": ("critical time step at l = 4 over 4 times that at l = 1", "1", 0.99, 1.01),
    "MIX-shift": ("share of steps in gamma_L at which the mean speed rises", "1", 1, None),
    "MIX-lin": ("R^2 of the straight line through the density up to 80 % of the tip speed", "1", 0.9, None),
    "MIX-M1": ("deviation of the mean speed from the original, M1", "%", None, 5),
    "MIX-M2": ("most frequent speed, M2 less M1", "m/s", None, -0.01),
    "MIX-M3": ("most frequent speed, M3 less M1", "m/s", 0.01, None),
    "MIX-liq": ("mean speed, liquid 0.05 less 0.005", "m/s", 0, None),
    "MIX-jkr1": ("difference of the densities from the original, M1 less the smaller of M2 and M3", "1", None, 0),
    "MIX-jkr23": ("difference of the densities from the original, smaller of M2 and M3 over M1", "1", 1.5, None),
    "MIX-Dd": ("most frequent speed, l = 16 less l = 8", "m/s", None, 0),
    "W02": ("smallest rise of mu_eff from one spacing to the next", "1", 0, None),
    "M01": ("mean level, smaller less larger grains in one ring", "mm", 0, None),
    "M02": ("difference of mean levels over their mean, rings widened by 1.4 d", "1", None, 0.05),
    "M03": ("largest d over b at which a ring holds within 5 % of what it holds with the published grains", "1", 0.3,
            0.6),
    "M09": ("share of the change of solid volume within 3 d of the surface, 200 to 250 ms", "1", 0.8, None),
    "M10": ("share of statements that hold: 95 % full at 400 ms; most powder within 90 deg of 0 deg at 100 ms", "1", 1,
            None),
    "M11": ("depth of motion over the ring's, passages 3 and 4", "1", 0.2, 0.5),
    "M07": ("fraction at 180 deg after two passages at 0.2 m/s less that after one at 0.09 m/s", "1", 0.003, None),
    "M23": ("filled mass without shaking over that with it", "1", None, 0.5),
    "M08": ("rise of upper less lower third from two to six passages at 0.09 m/s", "1", 0.003, None),
    "M12": ("rise of the mean fraction, passages 4 to 6 over 2 to 4, at 0.09 m/s", "1", None, 1),
}

# Labels of rows whose trend is not a number yet.
LABELS = {
    "H03": "filling level near the measured one", "H04": "filling level near the measured one",
    "AOR-M1": "deviation of M1 from the original",
}

NOT_A_TARGET = re.compile(r"input|not a target|context only|^measurement|^taken as")


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def limits(value, tolerance):
    """Least and largest agreeing value, None where there is none."""
    between = re.match(r"([\d.e-]+) to ([\d.e-]+)", tolerance)
    if between:
        return float(between[1]), float(between[2])
    for pattern, take in (
        (r"rel ([\d.e-]+) ?%", lambda x: abs(value) * x / 100),
        (r"rel ([\d.e-]+)", lambda x: abs(value) * x),
        (r"abs ([\d.e-]+)", lambda x: x),
        (r"\+-([\d.]+) ?% of the mean.*\+-(?P<wide>[\d.]+) ?% overall", None),
        (r"\+-3 % / \+-(?P<wide>[\d.]+) ?%", None),
        (r"(?:\+-|extreme of 33 runs: \+-)([\d.]+) ?%", lambda x: abs(value) * x / 100),
        (r"\+-([\d.]+)", lambda x: x),
        (r"([\d.e-]+)$", lambda x: x),
    ):
        found = re.match(pattern, tolerance)
        if found and value is not None:
            half = abs(value) * float(found["wide"]) / 100 if take is None else take(float(found[1]))
            return value - half, value + half
    if value is not None and re.search(r"factor 2", tolerance):
        return value / 2, value * 2
    if value is not None and re.search(r"<= ?3 %", tolerance):
        return None, value
    at_most = re.match(r"<=([\d.]+)", tolerance)
    if at_most:
        return None, float(at_most[1])
    at_least = re.match(r">([\d.]+)", tolerance)
    if at_least:
        return float(at_least[1]), None
    return None, None


def setting_of(row):
    text = row.get("parameters") or row.get("settings") or ""
    if text.count("=") > 5 or len(text) > 70:
        keep = [part for part in text.split(";") if re.match(r"(method|l|mu_r|gamma|cv|gamma_L|powder)=", part)]
        text = ";".join(keep)
    return text.replace(";", "; ")


def experiment_of(identity):
    for name, pattern in EXPERIMENTS.items():
        if re.fullmatch(pattern, identity):
            return name
    for name, pattern in FAMILIES.items():
        if re.fullmatch(pattern, identity):
            return name
    return ""


# Sections of the thesis for the numbers that the targets give its experiments.
THESIS = {
    "E0": "exact results", "E1": "section 3.1", "E2": "section 3.2.1", "E3": "section 3.2.2",
    "E4": "sections 4.1.1 and 4.1.2", "E4/E5": "section 4.1", "E5": "sections 4.1.3 and 4.1.4",
    "E6": "section 4.1.5", "E7": "section 4.1.6", "E8": "section 4.1.7", "E9": "section 4.1.8",
    "E10": "section 4.2.1", "E11": "section 4.2.2", "E12": "section 4.2.3", "E13": "section 4.2.4",
    "E14": "section 5.1", "E15": "section 5.2", "E16": "sections 6.1 and 6.2", "E17": "section 6.3",
    "E18": "section 6.4", "E19": "section 6.5.1", "E20": "section 6.5.2", "E21": "section 6.5.3",
    "E22": "appendix A", "E22a": "appendix A", "E22b": "appendix A", "E22c": "appendix A", "E5,E14": "chapter 7",
}


def row_of(row, source):
    identity = row["id"]
    tolerance = row.get("acceptance_tolerance") or row.get("tolerance") or ""
    label, unit, published = row["quantity"], row["unit"], row["value"]
    kind = "value"
    low, high = limits(number(published), tolerance)
    if NOT_A_TARGET.search(tolerance):
        kind, low, high = "input", None, None
    elif identity in CRITERIA:
        kind = "trend"
        label, unit, low, high = CRITERIA[identity]
        published = "trend" if number(published) is None else published
    elif row["kind"] == "qualitative" or (low is None and high is None):
        kind = "trend"
        label = LABELS.get(identity, label)
    if number(published) is None and len(published) > 12:
        published = "trend"
    label = re.sub(r" before the final drop$", "", LABELS.get(identity, label))
    text = lambda x: "" if x is None else f"{x:.10g}"
    return [identity, source, THESIS.get(row["experiment"], row["experiment"]), row.get("model", ""), setting_of(row), label,
            "1" if unit in ("-", "") else unit, "trend" if published == "qualitative" else published, text(low),
            text(high), kind, row["source"].replace(source + " ", ""), experiment_of(identity)]


# Bulk processes of Dosta et al. 2024: mean of the codes' results, or of re-runs of two of them, and 5 % of it.
BULK = (
    ("DOS-I25", "case 3", "M1", "25,000 grains", "lowest place of the ball below its start", "mm", "138.35", "impact"),
    ("DOS-I25-t", "case 3", "M1", "25,000 grains", "time of the ball's lowest place", "ms", "30", "impact"),
    ("DOS-I50", "case 3", "M1", "50,000 grains", "lowest place of the ball below its start", "mm", "138.6", "impact"),
    ("DOS-I50-t", "case 3", "M1", "50,000 grains", "time of the ball's lowest place", "ms", "44", "impact"),
    ("DOS-SL", "case 1", "M1", "large opening", "grains a second through the opening", "1/s", "23200", "silo"),
    ("DOS-SS", "case 1", "M1", "small opening", "grains a second through the opening", "1/s", "7737", "silo"),
    ("DOS-SR", "case 1", "M1", "both openings", "rate of the large over the small opening", "1", "3.1", "silo"),
)
BULK_PLACE = {"DOS-SL": "mean of the codes", "DOS-SR": "mean of the codes", "DOS-SS": "re-run of MUSEN"}


def bulk_rows():
    for identity, section, model, setting, quantity, unit, published, experiment in BULK:
        value = float(published)
        yield [identity, "Dosta 2024", section, model, setting, quantity, unit, published, f"{0.95 * value:.10g}",
               f"{1.05 * value:.10g}", "value", BULK_PLACE.get(identity, "re-runs of LIGGGHTS and MUSEN"), experiment]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["id", "source", "section", "model", "setting", "quantity", "unit", "published", "lower", "upper",
                     "kind", "place", "experiment"])
    for file, source in SOURCES:
        with open(f"{sys.argv[1]}/targets-{file}.csv", newline="", encoding="utf-8") as table:
            for row in csv.DictReader(table):
                writer.writerow(row_of(row, source))
    writer.writerows(bulk_rows())


main()
