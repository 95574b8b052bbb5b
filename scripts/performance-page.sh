# Sourced by the scripts that measure: puts their tables into docs/performance.md.

page=docs/performance.md

# The processor of this machine, as the page names it.
processor() { echo "$(nproc) cores of $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"; }

# measured CONDITIONS: the line above a table. Names the processor only if the page's machine is another one.
measured() {
    local other=
    grep -qFx "Machine: $(processor)." "$page" || other=", $(processor)"
    echo "$(date +%Y-%m-%d), commit $(git rev-parse --short HEAD)$other, $1."
}

# put NAME FILE: replaces the lines between <!-- NAME --> and <!-- end of NAME --> in the page by those of FILE.
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
