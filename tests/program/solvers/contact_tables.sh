#!/bin/sh
# contact_tables.sh FOLDER: prints FOLDER/tables.txt, made anew from FOLDER/verdicts.csv, and from those of the game
# engines, FOLDER/bullet.csv and FOLDER/dart.csv, if they are there.
set -eu
cd "$1"
awk -F, '
  BEGIN {
    kinds = split("unique,solution within rho,ambiguous,eps-solution,wrong,invalid,crash,time limit", kind, ",")
    split("U,S,A,e,w,i,C,T", letter_of, ",")
    for (k = 1; k <= kinds; ++k) letters[kind[k]] = letter_of[k]
    kind[++kinds] = "unfounded"
    kind[++kinds] = "modest"
  }
  NR == 1 { next }
  {
    name = $1; solver = $4; family = solver
    sub(/-.*/, "", family)
    if (!((family, name) in size)) { file[family, ++files[family]] = name; size[family, name] = $2 }
    if (!(solver in total)) column[family, ++columns[family]] = solver
    total[solver]++
    what = $6 == "crash" || $6 == "time limit" ? $6 : $9
    count[solver, what]++
    letter = what in letters ? letters[what] : "?"
    if ($6 == "0" && letter ~ /[wi]/) { letter = letter "!"; count[solver, "unfounded"]++ }
    if ($6 != "0" && letter ~ /[USA]/) { letter = letter "+"; count[solver, "modest"]++ }
    cell[name, solver] = cell[name, solver] " " letter
  }
  END {
    split("fc3d gfc3d fc2d lcp", order, " ")
    split("3D|3D, global form|2D|LCP", titles, "|")
    print "| solver | runs | unique | solution within rho | ambiguous | eps-solution | wrong | invalid | crash | time limit |", \
          "success, yet wrong or invalid | failure, yet certified |"
    print "|---|---|---|---|---|---|---|---|---|---|---|---|"
    for (f = 1; f <= 4; ++f) for (c = 1; c <= columns[order[f]]; ++c) {
      solver = column[order[f], c]
      printf "| %s | %d |", solver, total[solver]
      for (k = 1; k <= kinds; ++k) printf " %d |", count[solver, kind[k]]
      print ""
    }
    print "\nOf each file and solver, the verdicts at 1e-4, 1e-8 and 1e-14: **U** unique, **S** solution within rho,"
    print "**A** ambiguous, **e** eps-solution, **w** wrong, **i** invalid, **C** crash, **T** time limit; **!** success was"
    print "reported, and the answer is wrong or invalid; **+** failure was reported, and the answer is certified."
    for (f = 1; f <= 4; ++f) {
      g = order[f]
      printf "\n| %s | %s |", titles[f], g == "lcp" ? "unknowns" : "contacts"
      rule = "|---|---|"
      for (c = 1; c <= columns[g]; ++c) {
        printf " %s |", substr(column[g, c], length(g) + 2)
        rule = rule "---|"
      }
      print "\n" rule
      for (r = 1; r <= files[g]; ++r) {
        name = file[g, r]
        printf "| %s | %s |", name, size[g, name]
        for (c = 1; c <= columns[g]; ++c) printf "%s |", cell[name, column[g, c]]
        print ""
      }
    }
  }' verdicts.csv
# engine NAME TITLE BEST SWEEPS SETTINGS: tables of NAME.csv; of all settings of pgs, BEST has the last word, and SWEEPS
# says in words which it is.
engine() {
  [ -f "$1.csv" ] || return 0
  awk -F, -v title="$2" -v best="$3" -v sweeps="$4" -v settings="$5" '
    NR == 1 { next }
    {
      name = $1
      family = $1 ~ /^lcp/ ? "LCP" : "3D"
      if (!((family, name) in seen)) { file[family, ++files[family]] = name; seen[family, name] = 1 }
      if (!((family, $3) in known)) { column[family, ++columns[family]] = $3; known[family, $3] = 1 }
      letter = $5 == "crash" ? "C" : $5 == "time limit" ? "T" : $8 == "unique" ? "U" : $8 == "solution within rho" ? "S" : \
               $8 == "ambiguous" ? "A" : $8 == "eps-solution" ? "e" : $8 == "invalid" ? "i" : $10 != "" ? $10 : \
               $8 == "wrong" ? "w" : "?"
      if ($5 == "0" && letter ~ /^[wi]$/) letter = letter "!"
      cell[family, name, $3] = cell[family, name, $3] " " letter
      if (family == "3D" && $3 == "pgs" && $2 == best) {
        found[name] = sprintf("%s | %s | %s | %s | %s |", $8, $9, $10, $11, $12)
      }
    }
    END {
      print "\n" title "\n\nThe sweeps of pgs " sweeps ":\n"
      print "| 3D | for the cone | backward error | right for | `--law box` | backward error |\n|---|---|---|---|---|---|"
      for (r = 1; r <= files["3D"]; ++r) printf "| %s | %s\n", file["3D", r], found[file["3D", r]]
      print "\nOf each file and solver, the verdicts for the cone " settings ", letters as above, and"
      print "**box** wrong for the cone, right for this pyramid; **!** success was reported, and the answer is right for"
      print "neither."
      split("3D LCP", order, " ")
      for (f = 1; f <= 2; ++f) {
        g = order[f]
        printf "\n| %s |", g
        rule = "|---|"
        for (c = 1; c <= columns[g]; ++c) {
          printf " %s |", column[g, c]
          rule = rule "---|"
        }
        print "\n" rule
        for (r = 1; r <= files[g]; ++r) {
          printf "| %s |", file[g, r]
          for (c = 1; c <= columns[g]; ++c) printf "%s |", cell[g, file[g, r], column[g, c]]
          print ""
        }
      }
    }' "$1.csv"
}
engine bullet Bullet double "in double precision" "in single and in double precision"
engine dart DART 1e-14 "at 1e-14" "(of pgs at 1e-4, 1e-8 and 1e-14)"
