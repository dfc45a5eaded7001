#!/bin/sh
# Fetches from the distribution the sources of installed packages, at their very version, into FOLDER/<source>, with lists of
# its own, so that the system's stay as they are. Usage: fetch.sh FOLDER PACKAGE...
set -eu
mkdir -p "$1/apt/lists/partial" "$1/apt/cache/archives/partial"
cd "$1"
shift
here=$PWD
. /etc/os-release

# The system's own lists of this release, asked for sources instead of programs.
release="(^| )$VERSION_CODENAME"
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ ! -f "$list" ] || sed -nE "/$release/ s/^deb /deb-src /p" "$list"
done >apt/some.list
for list in /etc/apt/sources.list.d/*.sources; do
  if [ -f "$list" ] && grep -qE "^Suites:.*$release" "$list"; then
    sed -E '/^#/d; s/^Types:.*/Types: deb-src/' "$list"
    echo
  fi
done >apt/more.sources

apt() {
  apt-get -qq -o Dir::Etc::SourceList="$here/apt/some.list" -o Dir::Etc::SourceParts="$here/apt" \
    -o Dir::State::Lists="$here/apt/lists" -o Dir::Cache="$here/apt/cache" -o APT::Sandbox::User= \
    -o Acquire::http::Timeout=20 -o Acquire::Retries=2 "$@"
}
apt update
for package in "$@"; do
  source=$(dpkg-query -W -f='${source:Package}' "$package")
  version=$(dpkg-query -W -f='${source:Version}' "$package")
  rm -rf "$source" "$source.part"
  mkdir "$source.part"
  (cd "$source.part" && apt source --download-only "$source=$version" && dpkg-source --no-check -x ./*.dsc tree >/dev/null)
  mv "$source.part/tree" "$source"
  rm -rf "$source.part"
done
