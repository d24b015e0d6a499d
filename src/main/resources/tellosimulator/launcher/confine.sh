# The first process of the PID namespace of a confined program. It sets up a mount namespace in which
# the program can write only to a small disk of its own and sees nothing of the hidden folders. Then it
# starts the program without privileges, and ends everything that the program leaves behind.
# Arguments: MEGABYTES FILES STASH PROCESSES HIDDEN KEPT COMMAND...; HIDDEN and KEPT have a folder a line.
[ $$ -eq 1 ] || exit 125 # it ends all processes that it sees
fail() { echo "confine: $1" >&2; exit 125; }
mount -n -t proc proc /proc 2> /dev/null || fail "other processes cannot be hidden"
{ echo 0 > /proc/sys/user/max_user_namespaces; } 2> /dev/null || fail "namespaces cannot be limited"
megabytes=$1 files=$2 stash=$(cd "$3" && pwd -P) processes=$4 hidden=$5 kept=$6
shift 6

# The disk becomes /tmp once the files, which may be below /tmp themselves, are on it.
mount -n -t tmpfs -o "size=${megabytes}m,mode=1777" disk "$stash" || fail "there is no disk"
mkdir "$stash/flight" "$stash/kept" || fail "the disk cannot be used"
drop="setpriv --no-new-privs --bounding-set=-all --inh-caps=-all"
if setpriv --reuid 65534 --regid 65534 --clear-groups true 2> /dev/null; then
  drop="$drop --reuid 65534 --regid 65534 --clear-groups" # limits do not bind real root
  chown 65534:65534 "$stash/flight"
fi
if [ -d "$files" ]; then
  tar -C "$files" -cf - . | (cd "$stash/flight" && exec $drop tar -xf - --no-same-owner)
else
  (cd "$stash/flight" && exec $drop tar -xf - --no-same-owner) < "$files"
fi || echo "The files do not fit on the disk of $megabytes MB."

# Everything else becomes read-only. The kernel locks the other flags, which must be repeated.
mounts=$(cat /proc/self/mountinfo)
while read -r _ _ _ _ point flags _; do
  point=$(printf %b "$point")
  [ "$point" = "$stash" ] && continue
  mount -n -o "remount,bind,ro${flags#r[ow]}" "$point" 2> /dev/null
  [ ! -c "$point" ] && [ -w "$point" ] && fail "$point cannot be made read-only"
done << END
$mounts
END

# Of the devices, only those that every program needs; terminals and cameras belong to the user.
dev=$stash/kept/dev
mkdir "$dev" && mount -n -t tmpfs -o size=1m,mode=0755 dev "$dev" && mkdir "$dev/shm" ||
  fail "the devices cannot be hidden"
for device in null zero full random urandom; do
  : > "$dev/$device" && mount -n --bind "/dev/$device" "$dev/$device" || fail "/dev/$device is missing"
done
ln -s /proc/self/fd "$dev/fd"
ln -s fd/0 "$dev/stdin"
ln -s fd/1 "$dev/stdout"
ln -s fd/2 "$dev/stderr"

number=0
while IFS= read -r folder; do
  number=$((number + 1))
  [ -d "$folder" ] && mkdir "$stash/kept/$number" && mount -n --rbind "$folder" "$stash/kept/$number"
done << END
$kept
END
mount -n --move "$stash" /tmp || fail "the disk cannot be moved"
mount -n --move /tmp/kept/dev /dev || fail "the devices cannot be hidden"
while IFS= read -r folder; do
  [ ! -d "$folder" ] || mount -n -t tmpfs -o size=1m,mode=0755 cover "$folder" ||
    fail "$folder cannot be hidden"
done << END
$hidden
END
number=0
while IFS= read -r folder; do
  number=$((number + 1))
  [ -d "/tmp/kept/$number" ] && mkdir -p "$folder" && mount -n --move "/tmp/kept/$number" "$folder"
done 2> /dev/null << END
$kept
END
rm -rf --one-file-system /tmp/kept 2> /dev/null
while IFS= read -r folder; do
  [ -d "$folder" ] && mount -n -o remount,ro "$folder"
done 2> /dev/null << END
$hidden
END
for folder in /var/tmp /dev/shm; do
  [ ! -d $folder ] || mount -n --bind /tmp $folder || fail "$folder cannot be replaced"
done
mount -n -o remount,ro /dev 2> /dev/null
cd /tmp/flight || fail "there is no folder to fly in"

# "--nproc" counts threads, too.
$drop prlimit --core=0 --nproc="$((processes * 8 + 100))" -- "$@" < /dev/null
code=$?
tenths=0
kill -s TERM -- -1 2> /dev/null
while [ $tenths -lt 20 ] && kill -s 0 -- -1 2> /dev/null; do
  sleep 0.1
  tenths=$((tenths + 1))
done
exit $code
