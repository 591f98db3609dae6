# SPDX-License-Identifier: MIT
# Changes of sources, and whether the quick tests of the changed stage see them: what tests/faults.sh and tests/mutations.sh
# share. They read it at the root of the tree. Changes are made in a copy of the sources, build/faults, which stays for the
# next time.
copy=$PWD/build/faults/source
build=$PWD/build/faults/build

target_of() { printf '%s_quick_tests\n' "$1" | tr / _; }

# Runs the quick tests of a stage. Three minutes are many times what any stage takes; changed programs may never end, or
# fill the memory.
passes() {
  (ulimit -v 8000000 && GTEST_FAIL_FAST=1 GTEST_BRIEF=1 timeout 180 "$build/tests/$(target_of "$1")") >"$build.log" 2>&1
}

# prepare STAGE …: copies the sources and builds the quick tests of stages, which have to pass.
prepare() {
  # files that did not change keep their time: what was built before stays built
  mkdir -p "$copy"
  git ls-files --cached --others --exclude-standard | while read -r file; do
    if [ ! -f "$file" ] || cmp -s "$file" "$copy/$file"; then continue; fi
    mkdir -p "$copy/$(dirname "$file")"
    cp "$file" "$copy/$file"
  done
  cmake -S "$copy" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCOPPERMOON_STRICT=OFF >"$build.log" 2>&1 || {
    cat "$build.log" >&2
    exit 1
  }
  ninja -C "$build" $(for stage; do target_of "$stage"; done) >"$build.log" 2>&1 || {
    tail -n 30 "$build.log" >&2
    exit 1
  }
  for stage; do
    passes "$stage" || {
      cat "$build.log" >&2
      echo "$0 $stage: its tests fail without a change" >&2
      exit 1
    }
  done
}

# verdict FILE: prints what becomes of a file that was changed in the copy, and puts it back.
verdict() {
  if ! ninja -C "$build" -j1 "$(target_of "${1%/*}")" >"$build.log" 2>&1; then
    echo "DOES NOT COMPILE"
  elif passes "${1%/*}"; then
    echo SURVIVES
  else
    echo caught
  fi
  cp "$1" "$copy/$1"
}
