# Read by contact.sh and contact_box.sh: some recorders (contact_recorder.hpp) on every file of a folder, each run with
# ten seconds, judged by `slipproof certify`. The reader sets `slipproof` and `data`, `none` to the columns of no verdict
# but the first, and defines `allowed`, which prints the backward error above which answers are wrong, `columns`, which
# prints what identifies a run, and `verdicts`, which prints what is found.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Its exit code is the verdict.
certify() {
  timeout 120 "$slipproof" certify "$data/$file" --answer "$work/answer.json" --tolerance "$(allowed)" --json --quiet \
    "$@" || status=$?
}

record() {
  rm -f "$work/answer.json"
  status=0
  solved=$(timeout -k 1 10 "$recorder" "$data/$file" "$solver" "$setting" "$work/answer.json" 2>"$work/log") ||
    status=$?
  case $status in
    0) ;;
    2) cat "$work/log" >&2 && exit 1 ;; # the recorder's own refusal
    124 | 137) solved=time\ limit,, ;;
    *) solved=crash,, ;;
  esac
  printf %s "$(columns),$solved,"
  if [ $status -ne 0 ]; then
    echo "$none"
  else
    verdicts || echo "no verdict ($status)$none"
  fi
}

# every_run RECORDER...: a line for each run.
every_run() {
  (cd "$data" && ls fclib/* siconos/* lcp/*) | while read -r file; do
    for recorder in "$@"; do
      "$recorder" "$data/$file" >"$work/runs"
      while read -r solver setting; do record; done <"$work/runs"
    done
  done
}

# The tables, made anew from OUT's verdicts.
write_tables() {
  sh "$(dirname "$0")/contact_tables.sh" "$1" >"$work/tables.txt"
  cp "$work/tables.txt" "$1/tables.txt"
}
