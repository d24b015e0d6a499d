#!/bin/sh
# Installs a Debian package, looks at it, and removes it; what is written goes into memory, and is
# gone at the end. The Java machine gets an option beside its own. To be run by without-jdk.sh.
set -e
deb=$1
option=$2
memory=$(mktemp -d)
mount -t tmpfs none "$memory"
mount -t tmpfs none /opt
for folder in usr var etc; do
    mkdir "$memory/$folder" "$memory/$folder.work"
    mount -t overlay overlay \
        -o "userxattr,lowerdir=/$folder,upperdir=$memory/$folder,workdir=$memory/$folder.work" \
        "/$folder"
done
dpkg --force-depends -i "$deb"
JAVA_TOOL_OPTIONS=$option tello-simulator --version
desktop=/usr/share/applications/tello-simulator.desktop
echo "menu: $(grep '^Exec' $desktop), $(grep '^MimeType' $desktop)"
echo "files: $(grep -o 'pattern="[^"]*"' /usr/share/mime/packages/tello-simulator.xml)"
dpkg -r tello-simulator
for file in /usr/bin/tello-simulator $desktop /opt/tello-simulator \
    /usr/share/mime/packages/tello-simulator.xml; do
    if [ -e $file ] || [ -L $file ]; then
        echo "left behind: $file"
    fi
done
