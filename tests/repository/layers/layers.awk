# First file: the rooms. Second: what solves. Every further file: one of the sources, as ./WING/ROOM/...
function wrong(message) {
  printf "src/%s:%d: %s\n", substr(FILENAME, 3), FNR, message
  failed = 1
}

# The room in which a file stands: rooms may have folders of their own.
function room_of(path) {
  while (sub(/\/[^\/]*$/, "", path))
    if (path in place) return path
  return ""
}

FNR == 1 { files++ }

files == 1 && /^[a-z_]+:/ {
  wing = $0
  sub(/:.*/, "", wing)
  next
}
files == 1 && /^[ \t]*[^# \t]/ {
  room = $1
  alone = sub(/[*]$/, "", room)
  if (room !~ "^" wing "/") wrong("the room " room " stands below the wing " wing)
  place[room] = ++rooms
  if (alone) standalone[room] = 1
}
files == 1 { next }

files == 2 && /^!/ { shows[substr($1, 2)] = 1 }
files == 2 && /^[^!#]/ { solves[$1] = 1 }
files == 2 { next }

# Whether a header, or the room or wing that it stands in, solves.
function is_solver(header,   path) {
  if (header in shows) return 0
  for (path = header; !(path in solves);)
    if (!sub(/\/[^\/]*$/, "", path)) return 0
  return 1
}

FNR == 1 {
  from = room_of(substr(FILENAME, 3))
  face = FILENAME !~ /^\.\/.*\//  # src/slipproof.hpp: the whole library
  if (!face && from == "") wrong("its folder is no room of src/layers.txt")
}

/^[ \t]*#[ \t]*include[ \t]*["<]/ {
  match($0, /["<].*/)
  bracket = substr($0, RSTART, 1)
  target = substr($0, RSTART + 1)
  sub(/[">].*/, "", target)
  to = room_of(target)
  if (target ~ /(^|\/)[.][.]?\//) {
    if (bracket == "\"" || to != "") wrong("\"" target "\" must not step between folders by . or ..")
  } else if (to == "") {
    if (bracket == "\"")
      wrong("\"" target "\" does not name a room of src/layers.txt: write \"wing/room/file\", and <...> for other libraries")
  } else if (from ~ /^report\// && is_solver(target)) {
    wrong(from " must not include " target ", which solves: whoever calls it solves, and passes the result")
  } else if (from != "" && to != from) {
    if (from in standalone)
      wrong(from " stands alone and must not include " target)
    else if (place[to] > place[from])
      wrong(from " must not include " target ": " to " comes later")
  }
}

END { exit failed }
