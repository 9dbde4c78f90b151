# Installs what the build needs: system packages by apt, the WASM toolchain and the library sources into .toolchain/,
# node packages into web/node_modules. Sourced by ./dev. Can be run again at any time.

# Every pinned version without a lock file. The library tags for machines without the Debian sources are in
# .dev/libraries.cmake and must name the same releases.
LLVM=19                 # clang, lld, clang-format, clang-tidy
SUITE=trixie            # the Debian release whose Emscripten and library sources are used
EMSCRIPTEN=3.1.69       # its version in that suite
EMSCRIPTEN_MIN=3.1.69   # oldest emcc accepted from PATH or $EMSDK
IMGUI=1.90.1 CATCH2=3.7.1 EIGEN=3.4.0 SDL2=2.32.4 LODEPNG='0.0~git20250402'
ACORN=8.15.0            # imported by Emscripten's optimiser; Debian's package is not an ES module
LIGHTHOUSE=11.7.1       # the last version that checks installable pages
NODE_MIN=18
PACKAGES=(build-essential cmake ninja-build git python3 clang-$LLVM lld-$LLVM llvm-$LLVM clang-format-$LLVM
          clang-tidy-$LLVM libclang-rt-$LLVM-dev patchelf libsdl2-dev libgl-dev libbenchmark-dev
          file     # tells CPack which files of a .deb are programs
          doxygen  # makes the reference from core's comments
          parallel) # tests the documented way to distribute a study
BROWSERS=(chromium firefox-esr xvfb xauth)
HEADLESS=chromium-headless-shell # the same engine without windows; some systems lack it
WEBKIT=webkit2gtk-driver # some systems lack it; their tests leave WebKit out
SLURM=(slurm-wlm munge) # a scheduler of clusters
MEASURES=(valgrind libbox2d-dev libchipmunk-dev) # instruction counts; the engines for comparison
AARCH64=(g++-aarch64-linux-gnu qemu-user-static) # another processor, for determinism

T=$ROOT/.toolchain
LOG=$T/setup.log

say() { printf '== %s\n' "$*"; }
die() { printf '%s\n' "$*" >&2; exit 1; }

# Runs a command with its output in the log and a progress display: seconds on a terminal, otherwise a dot every 5 s.
working() {
  local what=$1 start=$SECONDS pid; shift
  printf '== %s ' "$what"
  ( set -e; "$@" ) >>"$LOG" 2>&1 & pid=$!
  while kill -0 "$pid" 2>/dev/null; do
    sleep 0.5
    if [ -t 1 ]; then printf '\r== %s (%d s) ' "$what" $((SECONDS - start))
    elif (( (SECONDS - start) / 5 > ${dots:-0} )); then local dots=$(( (SECONDS - start) / 5 )); printf .; fi
  done
  wait "$pid" || { echo; die "set-up failed at: $what (see .toolchain/setup.log)"; }
  if [ -t 1 ]; then echo; else printf ' %d s\n' $((SECONDS - start)); fi
}

# A step is done if its stamp file has the same text. The text contains versions and, where needed, the folder.
is_done() { [ "$(cat "$T/$1.ok" 2>/dev/null)" = "$2" ]; }
mark_done() { printf '%s\n' "$2" >"$T/$1.ok"; }

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

apt_need() {
  local missing=() name
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
  done
  [ ${#missing[@]} = 0 ] && return
  [ "$(id -u)" = 0 ] || sudo -v || die "set-up needs root for: apt-get install ${missing[*]}"
  working "apt-get update" as_root apt-get -q -o DPkg::Lock::Timeout=300 update
  working "apt-get install ${missing[*]}" as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    --no-install-recommends -o DPkg::Lock::Timeout=300 install "${missing[@]}"
}

emcc_version() { "$1" --version 2>/dev/null | sed -nE '1s/.* ([0-9]+\.[0-9]+\.[0-9]+).*/\1/p'; }
at_least() { [ -n "$2" ] && printf '%s\n%s\n' "$1" "$2" | sort -V -C; }

# The user's own Emscripten, if it is new enough. The cache of a system package is read-only.
own_emscripten() {
  local emcc root
  for emcc in "${EMSDK:+$EMSDK/upstream/emscripten/emcc}" "$(command -v emcc || true)"; do
    [ -x "$emcc" ] || continue
    at_least "$EMSCRIPTEN_MIN" "$(emcc_version "$emcc")" || continue
    root=$("$(dirname "$emcc")/em-config" EMSCRIPTEN_ROOT 2>/dev/null) || continue
    case $root in /usr/share/*) continue ;; esac
    echo "$root"; return
  done
}

# A private apt view of another suite. The system's own sources, pins and package state do not change. It uses the
# machine's present mirror.
private_apt() {
  local d=$T/apt mirror keyring=/usr/share/keyrings/debian-archive-keyring.gpg kind
  APT=(-q -o Dir::State::lists="$d/lists" -o Dir::Cache="$d/cache" -o Dir::Etc::sourcelist="$d/sources.list"
       -o Dir::Etc::sourceparts=/dev/null -o Dir::Etc::preferencesparts=/dev/null -o Dir::State::status=/dev/null
       -o Acquire::Languages=none -o APT::Sandbox::User=root)
  [ -e "$d/ready" ] && return
  rm -rf "$d"; mkdir -p "$d/lists/partial" "$d/cache/archives/partial"
  mirror=$(apt-get indextargets --format '$(REPO_URI)' | awk '!/security/ && !uri { uri = $0 } END { print uri }')
  [ -n "$mirror" ] || die "apt has no Debian mirror configured"
  for kind in deb deb-src; do echo "$kind [signed-by=$keyring] $mirror $SUITE main"; done >"$d/sources.list"
  working "package lists of Debian $SUITE" apt-get "${APT[@]}" update
  touch "$d/ready"
}

unpack_emscripten() {
  local debs=$T/debs root=$T/root lib=$T/lib runtime=$T/runtime em=$T/root/usr/share/emscripten deb name program
  rm -rf "$debs" "$root" "$lib" "$runtime"; mkdir -p "$debs" "$root" "$lib" "$runtime"
  (cd "$debs" && apt-get "${APT[@]}" download "emscripten=$EMSCRIPTEN*" binaryen libc6 libgcc-s1 libstdc++6)

  # Leaves out 1.5 GB of prebuilt library variants that we never link.
  dpkg-deb --fsys-tarfile "$debs"/emscripten_*.deb | tar -x -C "$root" \
    --exclude='*/wasm32-emscripten/lto*' --exclude='*/wasm32-emscripten/pic' --exclude='*-mt*.a' --exclude='*-ww*.a' \
    --exclude='*-asan*.a' --exclude='*/libwasmfs*.a' --exclude='*/emscripten/test' --exclude='*/share/doc' \
    --exclude='*/share/man'
  dpkg-deb -x "$debs"/binaryen_*.deb "$root"
  for deb in "$debs"/lib*.deb; do dpkg-deb -x "$deb" "$runtime"; done

  # Binaryen is the only native part. It is linked against a newer libc, so it gets the loader and libraries of that
  # suite.
  for name in 'ld-linux-*.so.*' libc.so.6 libm.so.6 libstdc++.so.6 libgcc_s.so.1; do
    cp -L "$(find "$runtime" -name "$name" -print -quit)" "$lib"/
  done
  cp "$(find "$root" -name 'libbinaryen.so*' -type f -print -quit)" "$lib"/
  chmod +x "$lib"/*
  patchelf --force-rpath --set-rpath '$ORIGIN' "$lib"/libbinaryen.so*
  for program in "$root"/usr/bin/wasm*; do
    [ "$(head -c4 "$program" | tail -c3)" = ELF ] || continue
    patchelf --set-interpreter "$(echo "$lib"/ld-linux-*)" --force-rpath --set-rpath "$lib" "$program"
  done

  npm install --no-audit --no-fund --no-save --no-package-lock --prefix "$em" "acorn@$ACORN"
  cat >"$em/.emscripten" <<CONFIG
LLVM_ROOT = '/usr/bin'
LLVM_ADD_VERSION = '$LLVM'
CLANG_ADD_VERSION = '$LLVM'
BINARYEN_ROOT = '$root/usr'
NODE_JS = '$(command -v node)'
CACHE = '$em/cache'
CONFIG
  rm -rf "$debs" "$runtime"
}

unpack_source() { # Debian source package, version, folder
  local download=$T/download/$1
  rm -rf "$download" "$T/src/$3"; mkdir -p "$download" "$T/src/$3"
  (cd "$download" && apt-get "${APT[@]}" source --download-only "$1")
  tar -xf "$download/$1"_"$2"*.orig.tar.* -C "$T/src/$3" --strip-components=1
  rm -rf "$download"
}

source_of() { # Debian source package, version, folder
  is_done "src-$3" "$2" && return
  private_apt
  working "source of $3 $2" unpack_source "$@"
  mark_done "src-$3" "$2"
}

# Provides the source of Emscripten's own SDL2 port from disk, so that -sUSE_SDL=2 needs no download.
build_sdl2() {
  local em=$1 cache=$1/cache folder url
  read -r folder url < <(python3 - "$em" <<'PYTHON'
import re, sys
port = open(sys.argv[1] + '/tools/ports/sdl2.py').read()
version = re.search(r"^VERSION = '([^']+)'", port, re.M)
tag = re.search(r"^TAG = f?'([^']+)'", port, re.M)[1].replace('{VERSION}', version[1] if version else '')
print('SDL-' + tag, re.search(r"f?'(https://[^']+/)\{TAG\}\.zip'", port)[1] + tag + '.zip')
PYTHON
  )
  mkdir -p "$cache/ports/sdl2"
  rm -rf "$cache/ports/sdl2/$folder"
  cp -r "$T/src/sdl2" "$cache/ports/sdl2/$folder"
  echo "$url" >"$cache/ports/sdl2/.emscripten_url"
  EMCC_CORES=2 "$em/embuilder" build sdl2
  rm -rf "$cache/ports/sdl2/$folder"/{test,Xcode,VisualC*,android-project*,docs} "$cache/ports-builds"
}

debian_emscripten() {
  local em=$T/root/usr/share/emscripten
  is_done emscripten "$EMSCRIPTEN $LLVM $ACORN $ROOT" || {
    private_apt
    working "Emscripten $EMSCRIPTEN into .toolchain" unpack_emscripten
    rm -f "$T/sdl2.ok"
    mark_done emscripten "$EMSCRIPTEN $LLVM $ACORN $ROOT"
  }
  source_of libsdl2 "$SDL2" sdl2
  is_done sdl2 "$SDL2" || { working "SDL2 $SDL2 for WASM" build_sdl2 "$em"; mark_done sdl2 "$SDL2"; }
  echo "$em" >"$T/emscripten-root"
}

node_packages() {
  cmp -s "$ROOT/web/package-lock.json" "$T/node.ok" && [ -d "$ROOT/web/node_modules" ] && return
  working "node packages" npm --prefix "$ROOT/web" ci --ignore-scripts --no-audit --no-fund
  cp "$ROOT/web/package-lock.json" "$T/node.ok"
}

is_debian() { ( . /etc/os-release && [ "$ID" = debian ] ) 2>/dev/null; }

setup() {
  local own tool
  mkdir -p "$T"; : >"$LOG"

  if command -v apt-get >/dev/null; then
    apt_need "${PACKAGES[@]}"
    command -v npm >/dev/null && at_least "v$NODE_MIN" "$(node --version 2>/dev/null)" || apt_need nodejs npm
  fi
  for tool in cmake ninja git python3 node npm; do
    command -v "$tool" >/dev/null || die "set-up needs $tool on PATH; install it and run ./dev setup again"
  done
  at_least "v$NODE_MIN" "$(node --version)" || die "set-up needs Node.js $NODE_MIN or newer; this is $(node --version)"

  own=$(own_emscripten)
  if [ -n "$own" ]; then
    say "using the Emscripten at $own"; echo "$own" >"$T/emscripten-root"
  elif is_debian; then
    debian_emscripten
  else
    die "set-up needs Emscripten $EMSCRIPTEN_MIN or newer: put emcc on PATH or set EMSDK, and run ./dev setup again"
  fi

  # On Debian the libraries come from its source packages. Elsewhere CMake fetches the same releases.
  rm -f "$T/deps.cmake"
  if is_debian; then
    source_of imgui "$IMGUI" imgui
    source_of catch2 "$CATCH2" catch2
    source_of eigen3 "$EIGEN" eigen
    source_of lodepng "$LODEPNG" lodepng
    for tool in imgui catch2 eigen lodepng; do
      echo "set(FETCHCONTENT_SOURCE_DIR_${tool^^} \"\${CMAKE_CURRENT_LIST_DIR}/src/$tool\")"
    done >"$T/deps.cmake"
  fi
  rm -rf "$T/apt" "$T/download"

  node_packages
  say "set-up is complete: Emscripten $(emcc_version "$(cat "$T/emscripten-root")/emcc"), node $(node --version)"
}

setup_browsers() {
  mkdir -p "$T"; touch "$LOG"
  command -v apt-get >/dev/null || { say "no apt here: the browser tests use the Chrome and Firefox they find"; return; }
  apt_need "${BROWSERS[@]}"
  ( apt_need "$HEADLESS" ) || say "$HEADLESS cannot be installed here: the tests drive the whole browser"
  ( apt_need "$WEBKIT" ) || say "$WEBKIT cannot be installed here: the tests leave WebKit out"
}

setup_measures() {
  mkdir -p "$T"; touch "$LOG"
  command -v apt-get >/dev/null || { say "no apt here: without valgrind and Box2D their comparisons are left out"; return; }
  apt_need "${MEASURES[@]}"
}
