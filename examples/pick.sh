# A judge for the make scripts, which source this: of nine children, the two with the most of a column of gaitsmith breed
# are the parents of the next nine.

# breed_by FOLDER FIRST COLUMN ROUNDS: leaves in the folder, for each round, the best child in ROUND-picked.json, and what
# the picks so far have in common as the goal of ROUND-taste.json. gaitsmith: the program
breed_by() {
  local parents=("$2") round ordered one other
  echo first,second,verdict >"$1/picks.csv"
  for ((round = 1; round <= $4; round++)); do
    mapfile -t ordered < <("$gaitsmith" breed "${parents[@]}" --seed "$round" --difference 0.5 --out-prefix "$1/$round" |
      awk -F , -v name="$3" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) column = i; next } { print $column "," $2 }' |
      sort -t , -k 1,1 -gr | cut -d , -f 2)
    parents=("${ordered[@]:0:2}")
    for one in "${parents[@]}"; do
      for other in "${ordered[@]:2}"; do echo "$one,$other,first"; done
    done >>"$1/picks.csv"
    cp "${parents[0]}" "$1/$round-picked.json"
    "$gaitsmith" taste "$1/picks.csv" --out "$1/$round-taste.json" >/dev/null
  done
}
