#!/usr/bin/env bash
# The Debian package: made from the build, unpacked, and used as its user would.
#
# usage: packaging_test.sh BUILD_FOLDER          exit code 77: skipped, the tools are missing
set -euo pipefail
for tool in cpack dpkg-deb dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

cpack --config "$build/CPackConfig.cmake" -B "$folder/made" >"$folder/cpack.log" 2>&1 ||
  fail "cpack: $(tail -n 20 "$folder/cpack.log")"
package=$(find "$folder/made" -maxdepth 1 -name 'stanok_*.deb')
[[ -n $package ]] || fail "no package: $(cat "$folder/cpack.log")"
[[ "$(dpkg-deb --field "$package" Depends)" == *libmodbus* ]] || fail "the package does not depend on its libraries"
dpkg-deb --extract "$package" "$folder/unpacked"
usr=$folder/unpacked/usr
for file in bin/stanok bin/stanokd bin/stanok-drives bin/stanok-web bin/stanok-gateway lib/systemd/system/stanokd@.service lib/systemd/system/stanok-web@.service lib/systemd/system/stanok-gateway.service \
  lib/systemd/system/stanok-opcua.service lib/stanok/opcua/stanok-opcua.js lib/stanok/opcua/source/server.js lib/stanok/opcua/package-lock.json lib/sysusers.d/stanok.conf \
  share/bash-completion/completions/stanok share/zsh/vendor-completions/_stanok \
  share/fish/vendor_completions.d/stanok.fish share/man/man1/stanok.1 share/man/man1/stanok-program.1 \
  share/man/man1/stanok-drives.1 share/man/man8/stanokd.8 share/man/man8/stanok-web.8 share/man/man8/stanok-gateway.8 share/man/man8/stanok-opcua.8 \
  share/stanok/posts/freecad/stanok_post.py share/stanok/posts/neutral/stanok_neutral.py share/stanok/posts/neutral/stanok_program.py \
  share/doc/stanok/README.md share/doc/stanok/docs/integrator/install.md share/doc/stanok/copyright; do
  [[ -s $usr/$file ]] || fail "the package lacks usr/$file"
done
[[ $(stat -c %a "$usr/bin/stanokd") == 755 ]] || fail "stanokd cannot be executed by everyone"

# The programs run from where they are installed, with the machines and examples beside them.
"$usr/bin/stanok" simulate "$usr/share/stanok/examples/helix.nc" \
  --machine "$usr/share/stanok/machines/mill3.toml" >/dev/null || fail "simulate"
"$usr/bin/stanokd" --machine "$usr/share/stanok/machines/mill3.toml" --check-config >/dev/null || fail "stanokd"

# The server of OPC UA says what it wants of npm.
if command -v node >/dev/null; then
  [[ $("$usr/bin/stanok-opcua" --help) == *--daemon* ]] || fail "stanok-opcua --help"
  text=$("$usr/bin/stanok-opcua" --daemon "mill=$folder/op.sock" 2>&1) && fail "stanok-opcua runs without node-opcua"
  [[ $text == *"npm ci"* ]] || fail "stanok-opcua: $text"
fi

# The Python package, where it was built: it needs nothing of the build, and finds the cycles of the other package.
python_package=$(find "$folder/made" -maxdepth 1 -name 'python3-stanok_*.deb')
if [[ -n $python_package ]]; then
  [[ "$(dpkg-deb --field "$python_package" Depends)" == *python3-numpy*stanok\ \(=* ]] ||
    fail "python3-stanok depends on $(dpkg-deb --field "$python_package" Depends)"
  dpkg-deb --extract "$python_package" "$folder/unpacked"
  cat >"$folder/measure.nc" <<'TEXT'
#include "measure/features.nc"
M30
TEXT
  env -u LD_LIBRARY_PATH PYTHONPATH="$usr/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 - \
    "$usr/share/stanok" "$folder/measure.nc" <<'TEXT' || fail "the Python package"
import sys
import stanok
share, measure = sys.argv[1:]
assert stanok.__file__.startswith(share.removesuffix("/share/stanok")), stanok.__file__
result = stanok.simulate(f"{share}/machines/mill3.toml", f"{share}/examples/helix.nc")
assert result.ok and result[1].position.shape == (result.cycles, 3)
check = stanok.check(f"{share}/machines/mill3_probe.toml", measure)
assert check.ok, check.faults
TEXT
fi

# What cannot be looked at, since it was not built; everything else is.
left_out=""
if [[ -z $python_package ]] && grep -q 'CPACK_STANOK_PYTHON_FOLDER' "$build/CPackConfig.cmake"; then
  grep -q 'python3-stanok is left out' "$folder/cpack.log" || fail "cpack makes no python3-stanok and does not say why"
  left_out="python3-stanok: its module is not built (target stanok_python)"
fi

# completions WORD...: what bash offers behind the words, the last one being typed.
completions() {
  (
    # shellcheck source=/dev/null
    source "$usr/share/bash-completion/completions/stanok"
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _stanok
    echo "${COMPREPLY[*]}"
  )
}
expect_completions() {
  local wanted=$1 found
  shift
  found=$(completions "$@")
  [[ $found == "$wanted" ]] || fail "completion of '$*': $found, not $wanted"
}
expect_completions 'program process' stanok pro
expect_completions 'read remove run resume return retrace reset' stanok program r
expect_completions '--wait' stanok program run part.nc --w
expect_completions 'verify' stanok log ver
man_pages=$(find "$usr/share/man" -name 'stanok*' | wc -l)
((man_pages > 20)) || fail "only $man_pages manual pages"
grep -q "stanok $("$usr/bin/stanok" --version)" "$usr/share/man/man8/stanokd.8" || fail "stanokd(8) is of another version"

if command -v systemd-analyze >/dev/null; then
  for unit in stanokd@ stanok-web@ stanok-gateway stanok-opcua; do
    name=${unit%@}
    sed "s|/usr/bin/$name|$usr/bin/$name|; /^Documentation=/d" "$usr/lib/systemd/system/$unit.service" >"$folder/$unit.service"
  done
  for unit in stanokd@ stanok-web@ stanok-gateway stanok-opcua; do
    systemd-analyze verify "$folder/$unit.service" 2>"$folder/unit.log" || fail "the unit: $(cat "$folder/unit.log")"
  done
fi
if [[ -n $left_out ]]; then
  echo "skipped: $left_out; the package stanok has passed"
  exit 77
fi
echo "packaging: passed"
