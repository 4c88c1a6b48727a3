# First file: the layers. Every further file: one of the sources, as ./FOLDER/...
function wrong(message) {
  printf "src/%s:%d: %s\n", substr(FILENAME, 3), FNR, message
  failed = 1
}

FNR == 1 { files++ }

files == 1 && /^[ \t]*[^# \t]/ {
  layers++
  for (i = 1; i <= NF; i++) {
    folder = $i
    alone = sub(/[*]$/, "", folder)
    layer[folder] = layers
    if (alone) standalone[folder] = 1
  }
}
files == 1 { next }

FNR == 1 {
  split(FILENAME, path, "/")
  from = path[2]
  face = !(3 in path)  # src/slipproof.hpp: the whole library
  if (!face && !(from in layer)) wrong("the folder " from " has no line in src/layers.txt")
}

/^[ \t]*#[ \t]*include[ \t]*["<]/ {
  match($0, /["<].*/)
  bracket = substr($0, RSTART, 1)
  target = substr($0, RSTART + 1)
  sub(/[">].*/, "", target)
  to = target
  sub(/\/.*/, "", to)
  if (to == target || !(to in layer)) {
    if (bracket == "\"")
      wrong("\"" target "\" does not name a folder of src/layers.txt: write \"folder/file\", and <...> for other libraries")
  } else if (target ~ /(^|\/)[.][.]?\//) {
    wrong("\"" target "\" must not step between folders by . or ..")
  } else if (from in layer && to != from) {
    if (from in standalone)
      wrong(from " stands alone and must not include " target)
    else if (layer[to] == layer[from])
      wrong(from " must not include " target ": they are siblings")
    else if (layer[to] > layer[from])
      wrong(from " must not include " target ": " to " comes later")
  }
}

END { exit failed }
