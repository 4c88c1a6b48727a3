#!/bin/sh
# pages.sh PROJECT: every link of a page leads somewhere, every page is reached from README.md in two steps, and there are
# at most 60 of them, 30 outside `proofs`.
set -eu
cd "$1"
find . -name '*.md' -not -path './build*' -not -path './.*/*' -not -path '*/node_modules/*' | sed 's#^\./##' | sort | awk '
  function wrong(text) { print text; failed = 1 }
  # The path FOLDER/TARGET without its steps up.
  function path(folder, target,   parts, n, i, out, top) {
    n = split((folder == "" ? "" : folder "/") target, parts, "/")
    top = 0
    for (i = 1; i <= n; ++i) {
      if (parts[i] == "" || parts[i] == ".") continue
      if (parts[i] == "..") --top
      else out[++top] = parts[i]
    }
    target = ""
    for (i = 1; i <= top; ++i) target = target (i > 1 ? "/" : "") out[i]
    return target
  }
  # What a heading is called in links.
  function anchor(text) {
    text = tolower(text)
    gsub(/\]\([^)]*\)/, "", text)
    gsub(/[][`*.,:;!?()"<>=|\/\\$^&'"'"'+]/, "", text)
    gsub(/ /, "-", text)
    return text
  }
  function read(page,   line, folder, code, target) {
    folder = page
    if (!sub(/\/[^\/]*$/, "", folder)) folder = ""
    code = number = 0
    while ((getline line <page) > 0) {
      ++number
      if (line ~ /^```/) code = !code
      if (code) continue
      if (line ~ /^#+ /) { target = line; sub(/^#+ /, "", target); anchors[page, anchor(target)] = 1 }
      while (match(line, /\]\([^) ]+\)/)) {
        target = substr(line, RSTART + 2, RLENGTH - 3)
        line = substr(line, RSTART + RLENGTH)
        if (target ~ /^[a-z]+:/) continue
        links[++count] = (target ~ /^#/ ? page : path(folder, target))
        if (target ~ /^#/) links[count] = links[count] target
        from[count] = page
        place[count] = page ":" number
      }
    }
    close(page)
  }
  { pages[NR] = $0; known[$0] = 1; if ($0 !~ /^proofs\//) ++outside; read($0) }
  END {
    for (i = 1; i <= count; ++i) {
      target = links[i]; part = ""
      if (match(target, /#/)) { part = substr(target, RSTART + 1); target = substr(target, 1, RSTART - 1) }
      if (system("test -e '\''" target "'\''") != 0) wrong(place[i] ": there is no " target)
      else if (part != "" && (target in known) && !((target, part) in anchors)) wrong(place[i] ": " target " has no heading #" part)
      to[i] = target
    }
    near["README.md"] = 0
    for (step = 1; step <= 2; ++step)
      for (i = 1; i <= count; ++i)
        if ((from[i] in near) && near[from[i]] == step - 1 && (to[i] in known) && !(to[i] in near)) near[to[i]] = step
    for (i = 1; i <= NR; ++i) if (!(pages[i] in near)) wrong(pages[i] " is not reached from README.md in two steps")
    if (NR > 60) wrong("there are " NR " pages, at most 60 are read")
    if (outside > 30) wrong("there are " outside " pages outside proofs, at most 30 are read")
    exit failed
  }'
