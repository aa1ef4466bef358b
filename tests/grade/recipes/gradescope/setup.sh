#!/bin/sh
# Gradescope runs this once, when the container is built: the autograder's zip lies in $AUTOGRADER/source.
set -eu
AUTOGRADER=${AUTOGRADER:-/autograder}
cd "$AUTOGRADER/source/raytree"
./raytree grade --self-test
