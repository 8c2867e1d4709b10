#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# installed.sh BUILD: installs a build, moves the prefix elsewhere, and uses the program from an empty folder and an empty
# environment, as somebody would who has no checkout.
set -euo pipefail
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

DESTDIR="$scratch/stage" cmake --install "$build" --prefix /opt/meander >"$scratch/install.log"
prefix="$scratch/elsewhere"
mv "$scratch/stage/opt/meander" "$prefix"
(cd "$prefix" && find . -type f -exec cksum {} + | sort -k3) >"$scratch/before"

mkdir "$scratch/work"
cd "$scratch/work"
meander() { env -i HOME="$scratch/work" PATH=/usr/bin:/bin "$prefix/bin/meander" "$@"; }
say() { printf -- '-- %s\n' "$*"; }
fail() { printf 'installed.sh: %s\n' "$*" >&2; exit 1; }

say "the program says what it is"
meander --version | grep -q '^meander [0-9]' || fail "no version"

say "an example that comes with it, and what it leaves"
meander examples/first_run.lua --out here >/dev/null
for suffix in svg png csv jsonl; do [ -s "here/first_run.$suffix" ] || fail "no here/first_run.$suffix"; done

say "the same in a sandbox"
meander --sandbox examples/first_run.lua --out confined >/dev/null
cmp here/first_run.csv confined/first_run.csv

say "a world there and back through a picture"
meander convert worlds/office.toml office.png >/dev/null
meander convert office.png office.toml 2>/dev/null | grep -q '^world ' || fail "the picture was not read"

say "weights that come with it"
meander -e 'print(meander.mapping.model("nn4", { preset = "real" }))' | grep -q '^sonar_model: nn4' || fail "no weights"

say "a file of one's own comes first"
mkdir worlds
meander -e 'meander.world.new { title = "mine" }:save "worlds/office.toml"'
meander -e 'print(meander.world.open("worlds/office.toml").title)' | grep -qx mine || fail "not the file of the working folder"

say "a script from a pipe"
echo 'print(#meander.world.open("worlds/maze.toml"):places())' | meander | grep -q '^[1-9]' || fail "no places"

say "where was looked"
(meander -e 'meander.world.open "nowhere.xyz"' 2>&1 || true) | grep -qF "here or in $prefix/share/meander" || fail "no place named"

say "completion"
bash -n "$prefix/share/bash-completion/completions/meander"
grep -q '^#compdef meander' "$prefix/share/zsh/site-functions/_meander"
grep -q '^complete -c meander' "$prefix/share/fish/vendor_completions.d/meander.fish"

say "nothing was written where it is installed"
(cd "$prefix" && find . -type f -exec cksum {} + | sort -k3) | cmp - "$scratch/before"
