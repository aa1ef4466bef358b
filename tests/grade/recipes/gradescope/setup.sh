#!/bin/sh
# Gradescope runs this once, when the container is built: the autograder's zip lies in $AUTOGRADER/source.
set -eu
AUTOGRADER=${AUTOGRADER:-/autograder}
chmod 700 "$AUTOGRADER/source" # the solutions and the secret
cd "$AUTOGRADER/source/raytree"
./raytree grade --self-test
