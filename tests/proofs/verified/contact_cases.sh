#!/bin/sh
# contact_cases.sh PROGRAM CHECKER CLI CASES MUTANTS: of the certificate that is shipped, of those of all problems in CASES,
# and of so many mutants of each, the verified checker accepts what slipproof-check-contact does, in the same words, and
# judges the others as it does, or calls them not covered. It covers most.
set -e
program=$1 checker=$2 cli=$3 cases=$4 mutants=$5
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

# Changes a token, or a digit of it, or takes one away.
for certificate in *.cert; do
  awk -v mutants="$mutants" -v to="${certificate%.cert}" '
    $1 == "problem" { next }  # its name would reject most of them
    { for (i = 1; i <= NF; ++i) token[++count] = $i }
    END {
      srand(42)
      for (m = 1; m <= mutants; ++m) {
        place = 1 + int(rand() * count)
        way = int(rand() * 8)
        changed = token[place]
        if (way == 0) changed = token[1 + int(rand() * count)]
        if (way == 1) changed = ""
        if (way >= 2) {
          at = 1 + int(rand() * length(changed))
          changed = substr(changed, 1, at - 1) substr("0123456789abcdef-/.p", 1 + int(rand() * (way > 2 ? 10 : 20)), 1) substr(changed, at + 1)
        }
        name = to "." m ".mutant"
        for (i = 1; i <= count; ++i) print (i == place ? changed : token[i]) >name
        close(name)
      }
    }' "$certificate"
done

"$checker" *.cert >checked.txt
"$program" *.cert >verified.txt || [ $? = 4 ]
find . -name '*.mutant' | sort >list.txt
xargs "$checker" <list.txt >>checked.txt || true
xargs "$program" <list.txt >>verified.txt || true
# Which contact refutes, why something is rejected, and where it is unreadable, only the other checker says.
plain() { sed 's/ of the answer, by \(contact\|row\) [0-9]*/ of the answer/; s/: \(rejected\|unreadable\): .*/: \1/' "$1" | sort; }
plain checked.txt >checked.sorted
plain verified.txt | grep -v ': not covered: ' >verified.sorted
others=$(comm -13 checked.sorted verified.sorted | grep -v '^s ' || true)
covered=$(grep -c 'cert: accepted$' verified.txt)
all=$(ls *.cert | wc -l)
echo "$covered of $all certificates are covered, and accepted"
for verdict in accepted rejected unreadable 'not covered'; do
  echo "$(grep -c "mutant: $verdict" verified.txt) mutants: $verdict"
done
if [ -n "$others" ] || [ "$covered" -lt 19 ]; then
  echo "$others"
  exit 1
fi
