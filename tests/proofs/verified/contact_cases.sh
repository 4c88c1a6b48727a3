#!/bin/sh
# contact_cases.sh PROGRAM CHECKER CLI CASES: of the certificate that is shipped, and of those of all problems in CASES, the
# verified checker accepts what slipproof-check-contact does, in the same words, or calls it not covered. It covers most.
set -e
program=$1 checker=$2 cli=$3 cases=$4
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cp "$cases"/*.cert "$folder"
cp "$cases"/*.json "$folder"
for lines in examples laws notations; do
  awk -v to="$folder/$lines" 'NF { name = to "-" NR ".json"; print >name; close(name) }' "$cases/$lines.jsonl"
done
cd "$folder"
for problem in *.json; do
  "$cli" certify "$problem" --certificate "of-${problem%.json}.cert" >"${problem%.json}.txt" 2>&1 || true
done
"$checker" *.cert >checked.txt
"$program" *.cert >verified.txt || [ $? = 4 ]
# What a refutation rests on only the other checker says.
sed 's/ of the answer, by \(contact\|row\) [0-9]*/ of the answer/' checked.txt | sort >checked.sorted
grep -v ': not covered: ' verified.txt | sort >verified.sorted
others=$(comm -13 checked.sorted verified.sorted | grep -v '^s ' || true)
covered=$(grep -c ': accepted$' verified.txt)
all=$(ls *.cert | wc -l)
echo "$covered of $all certificates are covered, and accepted"
if [ -n "$others" ] || [ "$covered" -lt 19 ]; then
  echo "$others"
  exit 1
fi
