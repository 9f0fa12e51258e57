#!/usr/bin/env bash
# Runs once when Gradescope builds the image. Say in HSR_KIT where the kit is.
set -euo pipefail
HSR_KIT="${HSR_KIT:-https://example.org/hidden-surface-kit.git}"
apt-get update
apt-get install -y git g++
git clone --depth 1 "${HSR_KIT}" /autograder/kit
cd /autograder/kit
./viewer/setup build
cmake --preset release
cmake --build --preset release --target hsr
