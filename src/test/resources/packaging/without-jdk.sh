#!/bin/sh
# Runs a command where no JDK can be seen, as root of a mount namespace that ends with it:
#   unshare --user --map-root-user --mount sh without-jdk.sh FOLDER_OF_THE_JDK COMMAND...
set -e
jdk=$1
shift
mount -t tmpfs none "$jdk"
if [ -d /usr/lib/jvm ]; then
    mount -t tmpfs none /usr/lib/jvm
fi
if java -version 2>/dev/null; then
    echo "There is still a JDK: $(command -v java)" >&2
    exit 1
fi
exec "$@"
