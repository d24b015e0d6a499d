#!/bin/sh
# Starts the program with the options that a jar cannot carry. jpackage's own launcher would ask the
# package manager first to which package it belongs, which takes longer than the rest of the start.

# A stream that is closed would be given to the next file that is opened, and read as typed.
{ true 3<&0; } 2>/dev/null || exec </dev/null
{ true 3>&1; } 2>/dev/null || exec >/dev/null

# Java reads names of files in the language of the system, of which C knows no umlauts.
case ${LC_ALL:-${LC_CTYPE:-${LANG:-}}} in
'' | C | POSIX) export LC_ALL=C.UTF-8 ;;
esac

self=$(readlink -f "$0")
home=${self%/bin/*}
app=$home/lib/app

# The window has a class-data archive of its own, where a display was there when it was made.
archive=$app/ARCHIVE
case ${1-} in
'' | -* | *.yaml | *.yml)
    window=$app/WINDOW
    for word in "$@"; do
        if [ "$word" = --headless ]; then
            window=
        fi
    done
    if [ -e "$window" ]; then
        archive=$window
    fi
    ;;
esac

exec "$home/lib/runtime/bin/java" OPTIONS "HOLDS=$archive" -Djpackage.app-path="$self" \
    -cp "$app/tello-simulator.jar" tellosimulator.Main "$@"
