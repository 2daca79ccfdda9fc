# Sourced by run.sh, with its arguments: takes the options apart.
# shellcheck shell=bash
# Before sourcing: the comment at the script's top is its help, and `settings` names the variable that each option sets,
# as declare -A settings=([--build]=build). Afterwards: those are set, and what is no option is in `words`.

words=()
while (($#)); do
  case $1 in
    -h | --help) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "fuzz/${0##*/}"; exit 0 ;;
    -*)
      [[ ${settings[$1]-} ]] || { echo "${0##*/}: unknown option $1; see --help" >&2; exit 2; }
      (($# > 1)) || { echo "${0##*/}: $1 needs a value; see --help" >&2; exit 2; }
      printf -v "${settings[$1]}" %s "$2"
      shift ;;
    *) words+=("$1") ;;
  esac
  shift
done
