#!/usr/bin/env bash
# install_packages.sh KIND...: installs what is missing of the named kinds in packages.txt.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

wanted=()
for kind in "$@"; do
    while read -r line; do
        read -ra names <<<"${line#"$kind:"}"
        wanted+=("${names[@]}")
    done < <(grep "^$kind:" "$here/packages.txt")
done

missing=()
for package in "${wanted[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Run as root, or install these packages first: ${missing[*]}" >&2; exit 3; }
    as_root=(sudo)
fi
echo "Installing ${missing[*]}" >&2
"${as_root[@]}" apt-get -o DPkg::Lock::Timeout=300 update -qq >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -qq -y \
    --no-install-recommends "${missing[@]}" >&2
