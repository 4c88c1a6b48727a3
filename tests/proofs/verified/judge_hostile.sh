#!/bin/sh
# judge_hostile.sh JUDGE PAPER SCRATCH: whatever lies where the claims of a paper should be, the judge ends soon, says so with
# an exit code of its own, calls no claim proved, and writes no byte that a terminal would obey.
set -u
judge=$1 paper=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"
failed=0
allowed=0
# try WANTED ARGUMENT...: the exit code, one of WANTED
try() {
  wanted=$1
  shift
  timeout 60 "$judge" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
  code=$?
  case " $wanted " in
    *" $code "*) ;;
    *) echo "$*: exit code $code, expected one of $wanted"; failed=1 ;;
  esac
  proved=$(LC_ALL=C grep -c '^proved ' "$scratch/out")
  [ "$proved" -le "$allowed" ] || { echo "$*: $proved claims are proved"; failed=1; }
  if [ -n "$(LC_ALL=C tr -d '\n\040-\176' <"$scratch/out" | head -c 1)$(LC_ALL=C tr -d '\n\040-\176' <"$scratch/err" | head -c 1)" ]; then
    echo "$*: control characters in what it says"
    failed=1
  fi
}
# claims NAME: a folder of that name, whose claims.canonical comes from standard input, and NAME-file with them as a theorem
# file
claims() {
  mkdir -p "$scratch/$1/certificates" "$scratch/$1-file"
  cat >"$scratch/$1/certificates/claims.canonical"
  cp "$scratch/$1/certificates/claims.canonical" "$scratch/$1-file/claims.theorems"
}
canonical=$scratch/canonical
sed '/^slipproof-statement 1$/,$d' "$paper/claims.theorems" >"$canonical"
try 2
try 2 --at
try 2 --at "$scratch/none"
try 3 "$scratch/none"
try 3 --at "$scratch/none" "$canonical"
claims empty </dev/null
claims junk <<'TEXT'
not a claim
TEXT
head -c 65536 /dev/zero | claims zeros
head -c "$(($(wc -c <"$canonical") / 2))" "$canonical" | claims half
sed 's/$/\r/' "$canonical" | claims returns
printf 'setting \033[2J\007\n' | claims escapes
awk 'BEGIN { for (i = 0; i < 200000; ++i) printf "("; print "" }' | claims brackets
awk 'BEGIN { for (i = 0; i < 20000000; ++i) printf "x" }' | claims long
{ cat "$canonical"; cat "$canonical"; } | claims twice
for name in empty junk zeros half returns escapes brackets long twice; do
  try "3 4" "$scratch/$name"
  try "3 4" "$scratch/$name-file"
done
mkdir -p "$scratch/waiting" "$scratch/unending" "$scratch/nested/claims.theorems"
mkfifo "$scratch/waiting/claims.theorems"
ln -s /dev/zero "$scratch/unending/claims.theorems"
for name in waiting unending nested; do try "3 4" "$scratch/$name"; done
mkdir -p "$scratch/pipe/certificates" "$scratch/endless/certificates" "$scratch/folder/certificates/claims.canonical" "$scratch/loop"
mkfifo "$scratch/pipe/certificates/claims.canonical"
ln -s /dev/zero "$scratch/endless/certificates/claims.canonical"
ln -s . "$scratch/loop/again"
for name in pipe endless folder loop; do try "3 4" "$scratch/$name"; done
# A statement and a certificate that are pipes
claims bare <"$canonical"
mkfifo "$scratch/bare/certificates/P1.statement" "$scratch/bare/certificates/P1.cert"
allowed=1  # L16 is a cover whose regions say by themselves that they cover
try "3 4 5" "$scratch/bare"
if [ -w /dev/full ]; then
  timeout 60 "$judge" "$scratch/bare" >/dev/full 2>"$scratch/err"
  code=$?
  [ "$code" -eq 6 ] || { echo "a full disk: exit code $code, expected 6"; failed=1; }
fi
[ "$failed" -eq 0 ] && echo "all refused"
exit "$failed"
