# Sourced by the scripts that measure: writes their tables to docs/performance.md.

page=docs/performance.md

# The processor of this machine, in the form of the page.
processor() { echo "$(nproc) cores of $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"; }

# measured CONDITIONS: the line above a table. It names the processor only if it is not that of the page.
measured() {
    local other=
    grep -qFx "Machine: $(processor)." "$page" || other=", $(processor)"
    echo "$(date +%Y-%m-%d), commit $(git rev-parse --short HEAD)$other, $1."
}

# put NAME FILE: replaces the lines between <!-- NAME --> and <!-- end of NAME --> of the page with FILE.
put() {
    if ! grep -qFx "<!-- $1 -->" "$page" || ! grep -qFx "<!-- end of $1 -->" "$page"; then
        echo "$page: no section <!-- $1 --> to <!-- end of $1 -->" >&2
        return 1
    fi
    awk -v name="$1" -v section="$2" '
        $0 == "<!-- end of " name " -->" { inside = 0 }
        !inside
        $0 == "<!-- " name " -->" { while ((getline line < section) > 0) print line; inside = 1 }' "$page" >"$2.new"
    cp "$2.new" "$page"
}
