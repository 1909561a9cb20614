#!/usr/bin/env bash
# Binaries that need nothing installed: static for Linux, and for Windows, each with completions, manual pages and its checksum
# in `dist`. Windows binaries need the linker of MinGW (Debian: apt install gcc-mingw-w64-x86-64).
set -euo pipefail
cd "$(dirname "$0")"
name={{project-name}}
built=${CARGO_TARGET_DIR:-target}

# The versions of the last test, if there was one.
[ -f Cargo.lock ] || cargo generate-lockfile

rm -rf dist
mkdir dist
for target in x86_64-unknown-linux-musl x86_64-pc-windows-gnu; do
    rustup target add "$target"
    cargo build --release --locked --target "$target"
    case $target in
        *windows*) cp "$built/$target/release/$name.exe" "dist/$name-$target.exe" ;;
        *) cp "$built/$target/release/$name" "dist/$name-$target" ;;
    esac
done
"dist/$name-x86_64-unknown-linux-musl" --version

here="$built/x86_64-unknown-linux-musl/release/$name"
mkdir dist/man dist/completions
"$here" man -o dist/man
for shell in bash elvish fish powershell zsh; do
    "$here" completions "$shell" >"dist/completions/$name.$shell"
done
cd dist
find . -type f ! -name SHA256SUMS -print0 | sort -z | xargs -0 sha256sum >SHA256SUMS
cat SHA256SUMS
