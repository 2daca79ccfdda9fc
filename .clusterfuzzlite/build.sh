#!/bin/bash -eu
exec bash -eu "$SRC/localgridseg/fuzz/oss-fuzz/build.sh"
