# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts that do many things in a row: each step writes to build/logs, a failing one does not
# stop the others, and a table of seconds ends the run.

step_names=()
step_results=()
step_seconds=()
step_failures=0
mkdir -p build/logs

# step NAME COMMAND...: runs the command; shows ctest's closing lines, or the end of the log if it failed.
step() {
  local name=$1 log status start=$SECONDS
  shift
  log="build/logs/${name//[^A-Za-z0-9]/_}.log"
  printf '=== %s\n' "$name"
  "$@" >"$log" 2>&1 </dev/null
  status=$?
  if [ "$status" -eq 0 ]; then
    grep -E 'tests passed|Total Test time|^(check|build|verification)_[a-z_]+:|^count_instructions:|^No tests were found' "$log" || true
    step_results+=("passed")
  else
    tail -n "${STEP_LOG_LINES:-80}" "$log"
    printf '=== %s FAILED (exit status %s); the whole log: %s\n' "$name" "$status" "$log"
    step_results+=("FAILED")
    step_failures=$((step_failures + 1))
  fi
  step_names+=("$name")
  step_seconds+=($((SECONDS - start)))
  printf '    %s s, %s s in all\n' "$((SECONDS - start))" "$SECONDS"
}

# Prints the table; its exit status is the one of the whole run.
finish_steps() {
  local i
  printf '\n%-34s %8s  %s\n' "step" "seconds" "result"
  for i in "${!step_names[@]}"; do
    printf '%-34s %8d  %s\n' "${step_names[$i]}" "${step_seconds[$i]}" "${step_results[$i]}"
  done
  printf '%-34s %8d  %s\n' "all" "$SECONDS" "$step_failures of ${#step_names[@]} failed"
  [ "$step_failures" -eq 0 ]
}

# build PRESET [cmake options]: configures and compiles build/PRESET.
build() {
  local preset=$1
  shift
  cmake -C cmake/build_once.cmake --preset "$preset" "$@" && cmake --build --preset "$preset"
}

# run_tests PRESET [ctest options]: what `make test` runs, in build/PRESET.
run_tests() {
  local preset=$1
  shift
  ctest --test-dir "build/$preset" --output-on-failure --no-tests=ignore -j "$(nproc)" "$@"
}

# sanitized_tests FOLDER [left-out labels [ctest options]]: those of build/FOLDER, by default what there is time for.
sanitized_tests() {
  local folder=$1 left_out=${2:-nightly|golden|slow} tool=tools/with_asan
  [ "${folder#tsan}" = "$folder" ] || tool=tools/with_tsan
  # ctest goes on without an expression that it cannot read, and leaves out nothing.
  if ctest --test-dir "build/$folder" -N -LE "$left_out" "${@:3}" 2>&1 | grep 'RegularExpression'; then
    echo "ctest reads expressions of at most 9 groups; the tests to leave out need fewer"
    return 1
  fi
  "$tool" ctest --test-dir "build/$folder" --output-on-failure --no-tests=error -j "$(nproc)" -LE "$left_out" "${@:3}"
}

# cellsearch_alone FOLDER [cmake options]: the search library must build, pass its tests and install where crumple is not.
cellsearch_alone() {
  local folder=$1
  shift
  cmake -C cmake/build_once.cmake -S cellsearch -B "build/$folder" -G Ninja \
    -DCMAKE_INSTALL_PREFIX="$PWD/build/cellsearch-installed" "$@" &&
    cmake --build "build/$folder" && sanitized_tests "$folder" && cmake --install "build/$folder"
}

# static_checks [options of check_tidy]: the static checks of tools/; with --since-recorded the slow ones of changed files.
static_checks() {
  local since=
  [[ " $* " != *" --since-recorded "* ]] || since=$(cat .ci/tidied)
  step "layers" tools/check_layers
  step "tools' own tests" python3 -m unittest discover -s tests/tools -p '*_test.py'
  step "style" tools/check_style
  step "format" tools/check_format
  step "headers" tools/check_headers --since "$since"
  step "documentation" tools/build_docs
  step "tidy" tools/check_tidy "$@"
}
