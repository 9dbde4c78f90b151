# Builds and packs what is published, and tests the packed files. Sourced by ./dev. docs/published-packages.md describes them.

PACKED=build/packages

# Packs what a component of build/release installs. CPack's tarballs have their files in the order of the disk, so these are
# not CPack's: pack_tree <component> <its place in the tarball> <file>
pack_tree() {
  local tree=build/release/packed/$1 owner=(--owner=0 --group=0)
  [[ $(tar --version) == *GNU* ]] || owner=(--uid 0 --gid 0)
  rm -rf "$tree"
  cmake --install build/release --strip --component "$1" --prefix "$ROOT/$tree/$2" >/dev/null
  find "$tree" -exec env TZ=UTC touch -t "$(TZ=UTC git log -1 --format=%cd --date=format-local:%Y%m%d%H%M.%S)" {} +
  (cd "$tree" && find "${2%%/*}" | LC_ALL=C sort | tar -cf - --format=ustar --no-recursion "${owner[@]}" --numeric-owner -T -) | gzip -9n >"$PACKED/$3"
  say "$3"
}

packages() {
  local version architecture
  git rev-parse HEAD >/dev/null 2>&1 || die "./dev packages needs a clone of the repository: the packages name its commit"
  [ -z "$(git status --porcelain)" ] || say "warning: files differ from the commit, so PROVENANCE.json says \"clean\": false"
  # Nothing of this machine and this moment goes into the packages.
  SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
  export SOURCE_DATE_EPOCH
  umask 022
  cmake --preset release >/dev/null
  cmake --build --preset release --target gaitsmith gaitsmith_core
  cmake --preset wasm >/dev/null
  cmake --build --preset wasm --target engine page_scripts
  rm -rf "$PACKED" build/release/packed
  mkdir -p "$PACKED"

  node web/package/pack.mjs build/wasm/web "$PACKED"
  node web/package/texts.mjs header "$PACKED"
  version=$(sed -n 's/^project(gaitsmith VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
  architecture=$(sed 's/.*, //' build/release/compiler.txt)
  pack_tree program usr "gaitsmith_${version}_$architecture.tar.gz"
  pack_tree library "gaitsmith-$version-cmake-$architecture" "gaitsmith-$version-cmake-$architecture.tar.gz"
  if [ "$(uname)" = Linux ] && command -v dpkg-shlibdeps >/dev/null && command -v file >/dev/null; then
    cpack --config build/release/CPackConfig.cmake -B build/release/packed -G DEB >build/release/cpack.log 2>&1 || { cat build/release/cpack.log; die "cpack failed"; }
    mv "build/release/packed/gaitsmith_${version}_$architecture.deb" "$PACKED/"
    say "gaitsmith_${version}_$architecture.deb"
  else
    say "the .deb is left out: it needs Linux with dpkg-shlibdeps and file"
  fi
  node web/package/provenance.mjs "$PACKED"
  say "packages, PROVENANCE.json and SHA256SUMS: $PACKED"
}

# Without a network, where the system lets us take it away.
check_packages() {
  local alone=()
  packages
  if unshare -rn true 2>/dev/null; then alone=(unshare -rn); fi
  GAITSMITH_PACKAGES=$PACKED ${alone[@]+"${alone[@]}"} node --test tests/packages/packages.test.mjs
}
