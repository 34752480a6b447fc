#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# CalculiX beside windfirm on one tree of 1000 segments: static equilibrium at 40 m/s with weight, and the first
# ten frequencies. Given: the build folder. CalculiX has no wind that follows the bent shape: it gets the same
# drag as dead forces on its nodes, so the shapes differ; what is compared is time. Its B31 beams have no circular
# section (squares of the same bending stiffness stand in), and are known to be too stiff where section or
# direction changes from one element to the next.
build=$1
tree=validation/computed_reference/bench_tree_1k.csv
out=$build/bench/ccx
ccx=$(command -v ccx) || {
    echo "bench-peers: skipped, CalculiX is not here (Debian package calculix-ccx)"
    exit 0
}
mkdir -p "$out" || exit

model() { # the tree, then the step named
    awk -F, -v step="$1" '
    NR == 1 { next }
    { n++; parent[n] = $2; for (k = 1; k <= 3; k++) { a[n, k] = $(2 + k); b[n, k] = $(5 + k) } r[n] = ($9 + $10) / 2 }
    END {
        print "*NODE\n1," a[1, 1] "," a[1, 2] "," a[1, 3]
        for (i = 1; i <= n; i++) printf "%d,%.9g,%.9g,%.9g\n", i + 1, b[i, 1], b[i, 2], b[i, 3]
        for (i = 1; i <= n; i++) printf "*ELEMENT,TYPE=B31,ELSET=E%d\n%d,%d,%d\n", i, i, parent[i] + 1, i + 1
        print "*NSET,NSET=ALL,GENERATE\n1," n + 1
        print "*ELSET,ELSET=TREE,GENERATE\n1," n
        print "*MATERIAL,NAME=WOOD\n*ELASTIC\n9e9,0.3\n*DENSITY\n800"
        side = (3 * 3.14159265358979) ^ 0.25 # of a square with the bending stiffness of a circle of radius 1
        for (i = 1; i <= n; i++) { # the section needs a direction across the axis
            x = b[i, 1] - a[i, 1]; y = b[i, 2] - a[i, 2]; z = b[i, 3] - a[i, 3]; l = sqrt(x * x + y * y + z * z)
            if (x * x < 0.5 * l * l) { p = 0; q = z; s = -y } else { p = -z; q = 0; s = x }
            m = sqrt(p * p + q * q + s * s)
            printf "*BEAM SECTION,ELSET=E%d,MATERIAL=WOOD,SECTION=RECT\n%.9g,%.9g\n%.9g,%.9g,%.9g\n", i, side * r[i], side * r[i], p / m, q / m, s / m
            c = x / l; f = 0.5 * 1.225 * 2 * r[i] * 40 * 40 * sqrt(1 - c * c) * l / 2 # cross-flow drag, half to each end
            fx[i + 1] += f * (1 - c * c); fy[i + 1] -= f * c * y / l; fz[i + 1] -= f * c * z / l
            j = parent[i] + 1
            fx[j] += f * (1 - c * c); fy[j] -= f * c * y / l; fz[j] -= f * c * z / l
        }
        print "*BOUNDARY\n1,1,6"
        if (step == "static") {
            print "*STEP,NLGEOM,INC=500\n*STATIC\n1,1\n*DLOAD\nTREE,GRAV,9.81,0,0,-1\n*CLOAD"
            for (i = 2; i <= n + 1; i++) printf "%d,1,%.9g\n%d,2,%.9g\n%d,3,%.9g\n", i, fx[i], i, fy[i], i, fz[i]
            print "*NODE PRINT,NSET=ALL\nU\n*END STEP"
        } else
            print "*STEP\n*FREQUENCY\n10\n*END STEP"
    }' "$tree" >"$out/$1.inp"
}

seconds() { # processor time of the children of this shell so far, to the variable spent
    times >"$out/times"
    spent=$(awk 'NR == 2 { for (k = 1; k <= 2; k++) { split($k, t, /[ms]/); s += 60 * t[1] + t[2] } print s }' "$out/times")
}

"$build/tests/bench_beam" peer >"$out/windfirm" || exit
read -r static modes f1 <"$out/windfirm"
for step in static frequency; do
    model $step
    seconds
    before=$spent
    (cd "$out" && OMP_NUM_THREADS=1 "$ccx" $step >$step.log 2>&1)
    seconds
    after=$spent
    case $step in static) ours=$static ;; *) ours=$modes ;; esac
    if grep -q "Job finished" "$out/$step.log"; then
        awk -v a="$before" -v b="$after" -v o="$ours" -v s=$step 'BEGIN {
            printf "%-9s CalculiX %.2f s, windfirm %.4f s: ratio %.0f\n", s, b - a, o, (b - a) / o }'
    else
        echo "$step: CalculiX did not finish ($out/$step.log)"
    fi
done
awk -v f="$f1" '/E I G E N V A L U E   O U T P U T/ { t = 1 } t && $1 == 1 && NF >= 4 {
    printf "first frequency: CalculiX %.4f Hz, windfirm %.4f Hz\n", $4, f; exit }' "$out/frequency.dat"
