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
package=$(find "$folder/made" -maxdepth 1 -name '*.deb')
[[ -n $package ]] || fail "no package: $(cat "$folder/cpack.log")"
dpkg-deb --field "$package" Depends | grep -q libmodbus || fail "the package does not depend on its libraries"
dpkg-deb --extract "$package" "$folder/unpacked"
usr=$folder/unpacked/usr
for file in bin/stanok bin/stanokd bin/stanok-drives lib/systemd/system/stanokd@.service lib/sysusers.d/stanok.conf \
  share/bash-completion/completions/stanok share/doc/stanok/install.md share/doc/stanok/copyright; do
  [[ -s $usr/$file ]] || fail "the package lacks usr/$file"
done
[[ $(stat -c %a "$usr/bin/stanokd") == 755 ]] || fail "stanokd cannot be executed by everyone"

# The programs run from where they are installed, with the machines and examples beside them.
"$usr/bin/stanok" simulate "$usr/share/stanok/examples/helix.nc" \
  --machine "$usr/share/stanok/machines/mill3.toml" >/dev/null || fail "simulate"
"$usr/bin/stanokd" --machine "$usr/share/stanok/machines/mill3.toml" --check-config >/dev/null || fail "stanokd"
bash -n "$usr/share/bash-completion/completions/stanok" || fail "the completion is no bash"

if command -v systemd-analyze >/dev/null; then
  unit=$folder/stanokd@.service
  sed "s|/usr/bin/stanokd|$usr/bin/stanokd|; /^Documentation=/d" "$usr/lib/systemd/system/stanokd@.service" >"$unit"
  systemd-analyze verify "$unit" 2>"$folder/unit.log" || fail "the unit: $(cat "$folder/unit.log")"
fi
echo "packaging: passed"
