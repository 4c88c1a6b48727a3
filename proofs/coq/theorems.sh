#!/bin/sh
# theorems.sh CERT|THEOREMS...: a file of Coq with a theorem for each certificate, that its statement is true, which Coq's
# kernel checks by computing; for a theorem file with one for each certificate in it. Then, beside what build.sh made:
# ulimit -s unlimited; coqc -Q FOLDER Slipproof FILE.v
# Exit code 3 where a file is no regular one, or has no such part.
set -eu
export LC_ALL=C
number=0

# text FILE.statement|FILE.cert: of a file, or of a part of a theorem file, FILE.theorems/NAME.cert
text() {
  case $1 in
    *.theorems/*)
      [ -f "${1%/*}" ] || { cat <"$1"; return; }
      named=${1##*/}
      awk -v theorem="theorem ${named%.*}" -v kind="${named##*.}" '
        $0 == "slipproof-statement 1" { here = "statement"; first = $0; getline; its = $0 == theorem; $0 = first "\n" $0 }
        $0 == "slipproof-certificate 1" || $0 == "slipproof-undecided 1" { here = "cert" }
        its && here == kind { print; found = 1 }
        END { exit !found }' "${1%/*}"
      ;;
    *) cat <"$1" ;;
  esac
}

is_there() {
  [ -f "$1" ] || case $1 in *.theorems/*) [ -f "${1%/*}" ] && text "$1" >/dev/null ;; *) false ;; esac
}

theorem() {
  number=$((number + 1))
  # Nothing of a name may end the comment.
  echo "(* $(printf %s "${1##*/}" | tr -c 'A-Za-z0-9_.-' '?') *)"
  for part in statement cert; do
    file=${1%.cert}.$part
    is_there "$file" || { echo "theorems.sh: theorem $number: its .$part is not a regular file" >&2; exit 3; }
    printf 'Definition %s%s := text "' $part $number
    text "$file" | sed 's/"/""/g'
    echo '"%literal.'
  done
  echo "Theorem holds$number : exists s, states statement$number s /\\ meaning s."
  echo "Proof. apply (accepts_sound statement$number cert$number). vm_cast_no_check (@eq_refl bool true). Qed."
}

echo 'From Slipproof Require Import Print Meaning Checker Sound Literal.'
for argument; do
  case $argument in
    *.theorems)
      [ -f "$argument" ] || { echo "theorems.sh: found no regular file, expected a theorem file" >&2; exit 3; }
      names=$(awk '$0 == "slipproof-statement 1" { getline; name = substr($0, 9) } $0 == "slipproof-certificate 1" { print name }' "$argument")
      for name in $names; do theorem "$argument/$name.cert"; done
      ;;
    *) theorem "$argument" ;;
  esac
done
