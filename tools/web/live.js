"use strict";
// The live view: what a running program tells over a WebSocket (docs/web.md). It draws at most once an animation frame and keeps a
// bounded amount of data, whatever the program sends.

const live = (() => {
    const most_rows = 500; // of messages that are shown
    const most_messages = 2000; // that are kept
    const most_faults = 600;
    const most_series = 12; // fields that are plotted at once
    const plotted = 60; // seconds
    const samples_kept = 1280; // of a field: 60 seconds, at most 20 a second
    const retry_after = 1000, silent_after = 3000; // milliseconds
    const old_state = 3; // seconds

    const root = find("#live");
    const tell = text => { find("#live-status").textContent = text; };
    const note = text => { find("#live-note").textContent = text; };
    const set_text = (element, text) => { if (element.textContent !== text) element.textContent = text; };
    const set_class = (element, name) => { if (element.className !== name) element.className = name; };
    const is_number = value => typeof value === "number" || typeof value === "boolean";
    const number_text = value => Number.isInteger(value) ? String(value) : Math.abs(value) >= 1e6 || Math.abs(value) < 1e-4 ? value.toPrecision(4) : String(+value.toPrecision(6));
    const value_text = value => typeof value === "number" ? number_text(value) : value === null || value === undefined ? "" : String(value);
    const seconds_text = seconds => seconds === undefined ? "" : seconds < 60 ? `${seconds.toFixed(1)} s` : seconds < 3600 ? `${Math.floor(seconds / 60)} min ${Math.floor(seconds % 60)} s` : `${Math.floor(seconds / 3600)} h ${Math.floor(seconds / 60) % 60} min`;
    const degrees = radians => `${(radians * 180 / Math.PI).toFixed(1)}°`;
    const svg = (name, attributes = {}, ...children) => {
        const element = document.createElementNS("http://www.w3.org/2000/svg", name);
        for (const [key, value] of Object.entries(attributes)) if (value !== undefined && value !== null) element.setAttribute(key, value);
        element.append(...children);
        return element;
    };

    // ---- What the program has told

    let program = null; // of "hello"
    let at = 0, at_received = 0; // seconds since the program began, and by the clock of the page
    let lost = 0, skipped = 0, state_age = 0;
    let messages = new Map(); // by id
    let systems = [], components = [], buses = [], faults = [];
    let series = []; // that are plotted
    let senders = new Map(); // components of which messages were received, by ID
    let arms = new Map(); // by component and generation
    let chosen = ""; // key of the message whose fields are shown
    let changed = new Set(), is_due = false;

    const is_acknowledgement = row => row.acknowledgement === "ack" || row.acknowledgement === "nak";
    const key_of = row => [row.generation, row.way, row.code, row.from, row.to, is_acknowledgement(row) ? row.acknowledgement : ""].join(" ").trim();
    const acknowledgement_texts = { request: "wants ACK", ack: "ACK", nak: "NAK" }; // as jausdump has them
    /** `kind`: what an acknowledgement is called. Those of SAE JAUS name no message. */
    function name_of(row, kind = acknowledgement_texts[row.acknowledgement]) {
        if (!is_acknowledgement(row)) return row.name || "unknown message";
        return row.code ? `${kind} of ${row.name || "unknown message"}` : kind;
    }
    const long_name_of = row => name_of(row, row.acknowledgement === "nak" ? "negative acknowledgement" : "acknowledgement");

    function due(...parts) {
        parts.forEach(part => changed.add(part));
        if (is_due) return;
        is_due = true;
        requestAnimationFrame(() => {
            is_due = false;
            const parts = changed;
            changed = new Set();
            for (const part of parts) draw[part]();
        });
    }

    /** Takes one frame of the program. */
    function take(frame) {
        if (frame.hello) {
            const again = program && program.program === frame.hello.program && program.name === frame.hello.name && (frame.at ?? 0) >= at;
            program = frame.hello;
            messages = new Map();
            senders = new Map();
            arms = new Map();
            faults = [];
            systems = components = buses = [];
            for (const one of series) again ? one.samples.push(at, NaN) : one.samples.clear();
            if (!again) resume();
            due("messages", "who", "buses", "faults", "arms");
        }
        at = frame.at ?? at;
        at_received = Date.now();
        lost = frame.lost ?? lost;
        skipped = frame.skipped ?? skipped;
        state_age = frame.state_age ?? 0;
        for (const row of frame.messages ?? []) take_message(row);
        if (frame.systems) systems = frame.systems;
        if (frame.components) components = frame.components;
        if (frame.systems || frame.components || senders.size !== 0) due("who");
        if (frame.buses) buses = frame.buses, due("buses");
        if (frame.faults?.length) {
            faults = faults.concat(frame.faults).slice(-most_faults);
            due("faults");
        }
        due("program", "messages", "plot");
    }
    function take_message(row) {
        const before = messages.get(row.id);
        row.units = { ...before?.units, ...row.units };
        row.fields ??= {};
        row.key = key_of(row);
        messages.set(row.id, row);
        if (messages.size > most_messages) messages.delete(messages.keys().next().value);
        for (const one of series) {
            if (one.key !== row.key || !is_number(row.fields[one.field])) continue;
            one.unit = row.units[one.field] ?? one.unit;
            one.samples.push(row.at ?? at, Number(row.fields[one.field]));
        }
        take_sender(row);
        take_joints(row);
    }
    /** Who sends is there. Its reports say what else is known: Report Component Status, Control and Identification, of both generations. */
    function take_sender(row) {
        if (row.way === "sent" || !row.from) return;
        const one = senders.get(row.from) ?? { id: row.from };
        one.heard_at = row.at ?? at;
        const value = name => row.fields[Object.keys(row.fields).find(path => path === name || path.endsWith(`.${name}`))];
        if (row.code === "4002h") {
            const state = value("primary_status_code") ?? value("status");
            if (state !== undefined) one.state = String(state), one.state_at = one.heard_at;
        } else if (row.code === "400Dh" && value("subsystem_id") !== undefined) {
            const parts = ["subsystem_id", "node_id", "component_id", "instance_id"].map(value).filter(part => part !== undefined);
            one.controller = parts.some(Number) ? parts.join(".") : "none";
            one.controller_at = one.heard_at;
            one.authority = parts.some(Number) ? value("authority_code") : undefined;
        } else if (row.code === "4B00h" && value("query_type") === "component_identification") {
            one.name = value("identification");
        }
        if (!senders.has(row.from) && senders.size === most_rows) senders.delete(senders.keys().next().value);
        senders.set(row.from, one);
    }

    // ---- Tables: cells are changed in place, so that a selection of text stays

    /** A cell is text, or {text, class, header}. */
    function fill(body, rows) {
        while (body.rows.length > rows.length) body.lastElementChild.remove();
        rows.forEach((cells, i) => {
            const row = body.rows[i] ?? body.insertRow();
            while (row.cells.length < cells.length) row.append(row.cells.length === 0 ? made("th", { scope: "row" }) : made("td"));
            cells.forEach((cell, j) => {
                const { text, class: name = "" } = typeof cell === "string" ? { text: cell } : cell;
                set_text(row.cells[j], text);
                set_class(row.cells[j], name);
            });
        });
    }
    /** Columns whose names begin with # have numbers. */
    const table_of = (caption, columns) => made("table", {}, caption ? made("caption", {}, caption) : null,
        made("thead", {}, made("tr", {}, ...columns.map(name => made("th", { scope: "col", class: name.startsWith("#") ? "number" : null }, name.replace("#", ""))))), made("tbody"));

    // ---- Messages

    const columns = [
        { name: "From", value: row => row.from ?? "", class: "id" },
        { name: "To", value: row => row.to ?? "", class: "id" },
        { name: "Message", value: row => name_of(row) },
        { name: "Code", value: row => row.code ?? "", class: "id minor" },
        { name: "Way", value: row => row.way ?? "", class: "minor" },
        { name: "Rate", value: row => at - row.at > 2.5 ? 0 : row.rate ?? 0, text: value => `${value.toFixed(1)} /s`, class: "number" },
        { name: "Count", value: row => row.count ?? 0, text: String, class: "number" },
        { name: "Bytes", value: row => row.size ?? 0, text: String, class: "number minor least" },
        { name: "Newest", value: row => row.at === undefined ? 0 : Math.max(0, at - row.at), text: seconds_text, class: "number minor" },
    ];
    let sorted_by = 0, is_descending = false;

    function draw_messages() {
        const words = find("#live-filter").value.toLowerCase().split(/\s+/).filter(Boolean);
        const fits = row => {
            const text = `${name_of(row)} ${long_name_of(row)} ${row.code} ${row.from} ${row.to} ${row.way} ${row.generation}`.toLowerCase();
            return words.every(word => text.includes(word));
        };
        const all_rows = [...messages.values()].filter(fits);
        const { value } = columns[sorted_by];
        const values = new Map(all_rows.map(row => [row, value(row)]));
        const by_text = new Intl.Collator("en", { numeric: true }).compare;
        const order = (a, b) => typeof a === "number" ? a - b : by_text(a, b);
        all_rows.sort((a, b) => (is_descending ? -1 : 1) * order(values.get(a), values.get(b)) || by_text(a.from ?? "", b.from ?? "") || by_text(name_of(a), name_of(b)) || a.id - b.id);
        const shown_rows = all_rows.slice(0, most_rows);

        const body = find("#live-messages tbody");
        const elements = new Map([...body.rows].map(element => [element.dataset.key, element]));
        const focused = document.activeElement;
        let is_reordered = false;
        shown_rows.forEach((row, i) => {
            let element = elements.get(row.key);
            elements.delete(row.key);
            if (!element) {
                element = made("tr", { "data-key": row.key }, ...columns.map(column => column.name === "Message"
                    ? made("th", { scope: "row" }, made("button", { type: "button", class: "choice", tabindex: "-1" }), made("span", { class: "bad" }))
                    : made("td", { class: column.class })));
            }
            if (body.rows[i] !== element) {
                body.insertBefore(element, body.rows[i] ?? null);
                is_reordered = true;
            }
            columns.forEach((column, j) => {
                const cell = element.cells[j], text = (column.text ?? String)(column.value(row));
                if (column.name !== "Message") return set_text(cell, text);
                set_text(cell.firstChild, text);
                set_text(cell.lastChild, row.error ? " not decoded" : "");
                cell.firstChild.setAttribute("aria-pressed", row.key === chosen);
            });
            set_class(element, [row.key === chosen ? "chosen" : "", at - row.at > 2.5 ? "quiet" : ""].join(" ").trim());
        });
        for (const element of elements.values()) element.remove();
        if (is_reordered || elements.size) {
            rove(body, "button.choice");
            if (body.contains(focused) && focused !== document.activeElement) focused.focus({ preventScroll: true });
        }
        const left = all_rows.length - shown_rows.length;
        set_text(find("#live-left"), left ? `${left} more: narrow the list by the filter.`
            : all_rows.length ? "" : messages.size ? "No message fits the filter." : "No message has passed yet.");
        draw_detail();
    }
    function draw_head() {
        find("#live-messages thead tr").replaceChildren(...columns.map((column, i) => made("th", {
            scope: "col", class: column.class, "aria-sort": i === sorted_by ? is_descending ? "descending" : "ascending" : null,
        }, made("button", { type: "button", class: "sort", onclick: () => {
            is_descending = i === sorted_by ? !is_descending : column.class?.includes("number") ?? false;
            sorted_by = i;
            draw_head();
            find(`#live-messages thead th:nth-child(${i + 1}) button`).focus();
            draw_messages();
        } }, column.name))));
    }

    const chosen_message = () => [...messages.values()].find(row => row.key === chosen);
    let detail_of = null; // what the elements of the detail were made for

    function draw_detail() {
        const row = chosen_message(), place = find("#live-detail");
        place.hidden = !row;
        if (!row) return;
        const names = Object.keys(row.fields);
        const made_for = JSON.stringify([row.key, names.map(name => [name, is_number(row.fields[name])])]);
        if (made_for !== detail_of) {
            detail_of = made_for;
            place.replaceChildren(
                made("div", { class: "title" }, made("h3", {}, long_name_of(row)), made("code", {}, row.code ?? "")),
                made("p", { class: "facts" }), made("p", { class: "note", hidden: true }), made("p", { class: "wrong", hidden: true }),
                made("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Fields" }, table_of("Fields; a number's name plots it", ["Field", "#Value", "Unit"])),
                made("p", { class: "live-hex", "aria-label": "Bytes" }),
                made("p", {}, made("button", { type: "button", class: "small", id: "live-bytes", onclick: show_bytes }, "Show bytes by field")));
            find("table", place).id = "live-fields";
            const body = find("tbody", place);
            for (const name of names) {
                const field = is_number(row.fields[name])
                    ? made("button", { type: "button", class: "choice", "data-field": name, "aria-label": `Plot ${name}`, onclick: () => plot(chosen, name) }, name) : name;
                body.append(made("tr", {}, made("th", { scope: "row" }, field), made("td", { class: "number" }), made("td")));
            }
            find("table", place).parentElement.hidden = names.length === 0;
            if (!has_module) find("#live-bytes").parentElement.remove();
        }
        set_text(find(".facts", place), [row.generation === "sae" ? "SAE" : "RA 3.3", row.way, `${row.from} → ${row.to}`, plural(row.size ?? 0, "byte"), `number ${row.count ?? 0}`, acknowledgement_texts[row.acknowledgement] ?? ""].filter(Boolean).join(" · "));
        const note = find(".note", place);
        note.hidden = !is_acknowledgement(row) || names.length > 0;
        set_text(note, row.acknowledgement === "nak" ? "The receiver has refused the message. A negative acknowledgement has no fields and gives no reason." : "The receiver has got the message. An acknowledgement has no fields.");
        const wrong = find(".wrong", place);
        wrong.hidden = !row.error;
        set_text(wrong, row.error ?? "");
        names.forEach((name, i) => {
            const cells = find("#live-fields tbody").rows[i].cells;
            set_text(cells[1], value_text(row.fields[name]));
            set_text(cells[2], row.units[name] ?? "");
            find("button", cells[0])?.setAttribute("aria-pressed", series.some(one => one.key === row.key && one.field === name));
        });
        set_text(find(".live-hex", place), spaced(row.hex ?? "") + (row.cut ? " …" : ""));
        const bytes = find("#live-bytes");
        if (bytes) {
            bytes.disabled = Boolean(row.cut) || !row.hex || document.documentElement.dataset.ready !== "true";
            bytes.title = row.cut ? "Only the first bytes of this message are here." : "";
        }
    }
    /** Opens the newest message in the view of messages. */
    function show_bytes() {
        const row = chosen_message();
        if (!row) return;
        show_view("messages");
        select_view("bytes");
        const hex = spaced((row.generation === "sae" ? "02" : "") + row.hex);
        find("#text").value = hex;
        read_text(hex);
        find("#result").focus();
    }

    // ---- Plots: one for each unit, of numbers over time

    /** Pairs of time and value, the newest `samples_kept` of them. Two that are less than 48 ms apart count as one. */
    class ring {
        constructor() { this.times = new Float64Array(samples_kept); this.values = new Float64Array(samples_kept); this.clear(); }
        clear() { this.first = this.size = 0; }
        place(i) { return (this.first + i) % samples_kept; }
        push(time, value) {
            const last = this.size ? this.place(this.size - 1) : -1;
            if (last >= 0 && time < this.times[last]) return;
            const is_same = last >= 0 && time - this.times[last] < 0.048 && !Number.isNaN(value) && !Number.isNaN(this.values[last]);
            if (is_same) { this.values[last] = value; return; }
            if (this.size === samples_kept) this.first = this.place(1);
            else ++this.size;
            const place = this.place(this.size - 1);
            this.times[place] = time;
            this.values[place] = value;
        }
        /** Those between two times, and the one before, to which a line leads. */
        between(from, to) {
            const found = [];
            for (let i = 0; i !== this.size; ++i) {
                const place = this.place(i), time = this.times[place];
                if (time < from) found.length = 0;
                if (time <= to) found.push([time, this.values[place]]);
            }
            return found;
        }
        copy() {
            const other = new ring();
            other.times.set(this.times);
            other.values.set(this.values);
            other.first = this.first;
            other.size = this.size;
            return other;
        }
    }
    let pointed = null; // seconds before the end of the plots: where the pointer is
    let paused_at = null; // the time at which the plots stand still
    let next_colour = 0;

    /** Plots a field of a message, or does not any more. */
    function plot(key, field) {
        const found = series.findIndex(one => one.key === key && one.field === field);
        if (found >= 0) series.splice(found, 1);
        else if (series.length === most_series) return note(`At most ${most_series} fields are plotted at once.`);
        else {
            const row = [...messages.values()].find(one => one.key === key), samples = new ring();
            const used = new Set(series.map(one => one.colour));
            while (used.has(next_colour % most_series)) ++next_colour;
            if (row && is_number(row.fields[field])) samples.push(row.at ?? at, Number(row.fields[field]));
            series.push({ key, field, unit: row?.units[field] ?? "", name: row ? name_of(row) : "", from: row?.from ?? "", to: row?.to ?? "", samples, colour: next_colour++ % most_series });
        }
        if (!series.length) next_colour = 0, resume();
        note(found >= 0 ? `${field} is not plotted any more.` : `${field} is plotted.`);
        due("plot", "messages");
    }
    function pause() {
        paused_at = at;
        for (const one of series) one.held = one.samples.copy();
        pause_shown();
    }
    function resume() {
        paused_at = null;
        for (const one of series) delete one.held;
        pause_shown();
    }
    function pause_shown() {
        find("#live-pause").setAttribute("aria-pressed", paused_at !== null);
        due("plot");
    }

    /** Round numbers between two limits, about `count` of them. */
    function ticks(least, most, count) {
        const rough = (most - least) / count, power = 10 ** Math.floor(Math.log10(rough));
        const step = [1, 2, 5, 10].map(one => one * power).find(one => one >= rough * 0.999);
        const found = [];
        for (let i = Math.ceil(least / step - 1e-9); i * step <= most + step * 1e-9; ++i) found.push(i * step);
        return { found, digits: Math.max(0, Math.min(12, -Math.floor(Math.log10(step) + 1e-9))) };
    }

    const height = 190, top = 12, bottom = 34, left = 58, right = 10;
    function draw_plot() {
        const is_any = series.length > 0;
        find("#live-plot-help").hidden = is_any;
        for (const id of ["#live-pause", "#live-clear", "#live-legend-place"]) find(id).hidden = !is_any;
        const to = paused_at ?? at, from = to - plotted;
        const kept = series.map(one => ({ ...one, points: (one.held ?? one.samples).between(from, to) }));
        const units = [...new Set(kept.map(one => one.unit))];
        const place = find("#live-panels");
        while (place.children.length > units.length) place.lastElementChild.remove();
        units.forEach((unit, i) => {
            if (!place.children[i]) place.append(made("figure", { class: "panel" }));
            draw_panel(place.children[i], unit, kept.filter(one => one.unit === unit), from, to);
        });
        draw_legend(kept);
    }
    function draw_panel(figure, unit, lines, from, to) {
        const width = Math.max(200, figure.clientWidth || 600);
        const values = lines.flatMap(one => one.points.map(point => point[1])).filter(value => !Number.isNaN(value));
        let least = values.length ? Math.min(...values) : 0, most = values.length ? Math.max(...values) : 1;
        const margin = most > least ? (most - least) * 0.06 : Math.abs(most) * 0.1 || 1;
        least -= margin;
        most += margin;
        const x = time => left + (time - from) / plotted * (width - left - right);
        const y = value => top + (most - value) / (most - least) * (height - top - bottom);
        const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
            "aria-label": `${lines.map(one => one.field).join(", ")}${unit ? " in " + unit : ""} over the last ${plotted} seconds, between ${number_text(least + margin)} and ${number_text(most - margin)}` });
        const { found, digits } = ticks(least, most, 4);
        for (const value of found) {
            picture.append(svg("line", { class: "grid", x1: left, x2: width - right, y1: y(value), y2: y(value) }),
                svg("text", { class: "tick", x: left - 6, y: y(value) + 4, "text-anchor": "end" }, Math.abs(value) >= 1e6 ? value.toPrecision(3) : value.toFixed(digits)));
        }
        const every = width < 420 ? 20 : 10;
        for (let second = -plotted; second <= 0; second += every) {
            picture.append(svg("line", { class: "grid", x1: x(to + second), x2: x(to + second), y1: top, y2: height - bottom }),
                svg("text", { class: "tick", x: x(to + second), y: height - bottom + 14, "text-anchor": second === 0 ? "end" : "middle" }, second === 0 ? "0 s" : String(second).replace("-", "−")));
        }
        picture.append(svg("text", { class: "tick axis", x: left + (width - left - right) / 2, y: height - 4, "text-anchor": "middle" }, paused_at === null ? "seconds before now" : "seconds before the pause"),
            svg("text", { class: "tick axis", x: 12, y: top + (height - top - bottom) / 2, "text-anchor": "middle", transform: `rotate(-90 12 ${top + (height - top - bottom) / 2})` }, unit || "no unit"));
        for (const one of lines) {
            let path = "", is_down = false, last = null;
            for (const [time, value] of one.points) {
                if (Number.isNaN(value)) { is_down = false; continue; }
                last = [Math.max(left, x(time)), y(value)];
                path += `${is_down ? "L" : "M"}${last[0].toFixed(1)} ${last[1].toFixed(1)}`;
                is_down = true;
            }
            picture.append(svg("path", { class: `line colour-${one.colour}`, d: path, "data-field": one.field, "data-points": one.points.length }));
            if (last) picture.append(svg("circle", { class: `dot colour-${one.colour}`, cx: last[0], cy: last[1], r: 3 }));
        }
        if (pointed !== null) draw_pointed(picture, lines, to, x, y, width);
        figure.replaceChildren(picture);
    }
    /** The values at the pointer: of each line its newest one until then. */
    function draw_pointed(picture, lines, to, x, y, width) {
        const time = to - pointed, side = x(time) > width / 2 ? -1 : 1;
        picture.append(svg("line", { class: "pointed", x1: x(time), x2: x(time), y1: top, y2: height - bottom }));
        for (const one of lines) {
            const point = one.points.filter(([sampled, value]) => sampled <= time && !Number.isNaN(value)).at(-1);
            if (!point) continue;
            picture.append(svg("circle", { class: `dot colour-${one.colour}`, cx: x(time), cy: y(point[1]), r: 3 }),
                svg("text", { class: `tick value colour-${one.colour}`, x: x(time) + side * 7, y: y(point[1]) - 4, "text-anchor": side < 0 ? "end" : "start" }, number_text(+point[1].toPrecision(4))));
        }
    }
    function point_at(event) {
        const picture = event.target.closest?.("svg");
        const before = pointed;
        pointed = null;
        if (event.type !== "pointerleave" && picture) {
            const box = picture.getBoundingClientRect(), width = box.width - left - right;
            const part = (event.clientX - box.left - left) / width;
            if (part >= 0 && part <= 1) pointed = plotted * (1 - part);
        }
        if (pointed !== before) due("plot");
    }
    function draw_legend(kept) {
        const body = find("#live-legend tbody");
        const wanted = kept.map(one => one.key + " " + one.field).join("\n");
        if (body.dataset.of !== wanted) {
            body.dataset.of = wanted;
            body.replaceChildren(...kept.map(one => made("tr", {},
                made("th", { scope: "row" }, made("span", { class: `swatch colour-${one.colour}`, "aria-hidden": "true" }), made("span", {}, one.field), made("span", { class: "of" }, `${one.name}, ${one.from} → ${one.to}`)),
                made("td", { class: "number" }), made("td", { class: "number" }), made("td", { class: "number" }),
                made("td", {}, made("button", { type: "button", class: "small", "aria-label": `Remove ${one.field} of ${one.name}`, onclick: () => plot(one.key, one.field) }, "Remove")))));
        }
        kept.forEach((one, i) => {
            const values = one.points.map(point => point[1]).filter(value => !Number.isNaN(value));
            const cells = body.rows[i].cells;
            const text = value => value === undefined || !Number.isFinite(value) ? "" : number_text(+value.toPrecision(4));
            set_text(cells[1], `${text(values.at(-1))} ${one.unit}`.trim());
            set_text(cells[2], text(Math.min(...values)));
            set_text(cells[3], text(Math.max(...values)));
        });
    }

    // ---- Joints: from the messages that have their positions or velocities, by name

    function take_joints(row) {
        const name = name_of(row).replace(/([a-z])([A-Z])/g, "$1_$2").replace(/\W+/g, "_").toLowerCase();
        const kind = name.match(/^(report|set)_(?:(commanded)_)?(?:\w+_)?joints?_(positions?|velocit(?:y|ies))$/);
        if (!kind) return;
        const [, verb, commanded, quantity] = kind;
        const joint = path => Number(path.match(/\d+/)[0]);
        const values = Object.entries(row.fields).filter(([path, value]) => typeof value === "number" && /joint/.test(path) && /\d/.test(path) && !/(^|[._])(index|unit|type|number_of\w*)$/.test(path))
            .sort(([a], [b]) => joint(a) - joint(b)).map(([, value]) => value).slice(0, 64);
        if (!values.length) return;
        const component = verb === "report" ? row.from : row.to;
        const key = `${row.generation} ${component}`;
        if (!arms.has(key)) {
            if (arms.size === 16) return;
            arms.set(key, { component, positions: {}, velocities: {} });
        }
        const arm = arms.get(key);
        arm[quantity.startsWith("position") ? "positions" : "velocities"][verb === "set" || commanded ? "commanded" : "reported"] = { values, at: row.at ?? at };
        due("arms");
    }
    /** The ends of the links, in lengths of the whole chain: the first is the base. */
    function chain(angles) {
        const ends = [[0, 0]];
        let direction = Math.PI / 2;
        for (const angle of angles) {
            direction += angle;
            const [x, y] = ends.at(-1);
            ends.push([x + Math.cos(direction) / angles.length, y + Math.sin(direction) / angles.length]);
        }
        return { ends, direction };
    }
    const size = 120; // of the chain, in the units of the picture
    function draw_chain(angles, name) {
        const { ends, direction } = chain(angles);
        const points = ends.map(([x, y]) => [x * size, -y * size]);
        const group = svg("g", { class: name, "data-angles": angles.map(angle => angle.toFixed(4)).join(" ") });
        group.append(svg("polyline", { class: "link", points: points.map(point => point.map(one => one.toFixed(1)).join(",")).join(" ") }));
        const [x, y] = points.at(-1), turn = -direction * 180 / Math.PI;
        group.append(svg("path", { class: "hand", d: "M0 0h4M11 -7h-7v14h7", transform: `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${turn.toFixed(1)})` }));
        points.slice(0, -1).forEach(([x, y]) => group.append(svg("circle", { class: "joint", cx: x.toFixed(1), cy: y.toFixed(1), r: 4.5 })));
        return { group, points };
    }
    function draw_arms() {
        const place = find("#live-arm-list");
        find("#live-arms").hidden = arms.size === 0;
        const known = new Map([...place.children].map(element => [element.dataset.arm, element]));
        for (const [key, arm] of arms) {
            let element = known.get(key);
            known.delete(key);
            if (!element) {
                element = made("div", { class: "arm", "data-arm": key }, made("h3", {}, arm.component), made("figure"),
                    made("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": `Joints of ${arm.component}` }, table_of("", ["Joint", "#Reported", "#Commanded", "#Velocity"])));
                place.append(element);
            }
            draw_arm(element, arm);
        }
        for (const element of known.values()) element.remove();
    }
    function draw_arm(element, { component, positions, velocities }) {
        const reported = positions.reported?.values ?? [], commanded = positions.commanded?.values ?? [];
        const speeds = (velocities.reported ?? velocities.commanded)?.values ?? [];
        const picture = svg("svg", { viewBox: "-136 -136 272 272", role: "img",
            "aria-label": `Arm ${component}: ${[reported.length ? "reported " + reported.map(degrees).join(", ") : "", commanded.length ? "commanded " + commanded.map(degrees).join(", ") : ""].filter(Boolean).join("; ")}` });
        picture.append(svg("circle", { class: "reach", r: size }), svg("path", { class: "base", d: "M-22 8h44M-14 8l6 -8h16l6 8" }));
        const main = reported.length ? draw_chain(reported, "reported") : null;
        if (main) picture.append(main.group);
        if (commanded.length) picture.append(draw_chain(commanded, "commanded").group); // thin: both are seen
        const { points } = main ?? (commanded.length ? draw_chain(commanded, "") : { points: [] });
        const angles = main ? reported : commanded;
        // Beside each joint its angle, away from the middle of the links that meet there.
        points.slice(0, -1).forEach(([x, y], i) => {
            const before = points[i - 1] ?? [x, y + size / angles.length], after = points[i + 1];
            let away = [2 * x - before[0] - after[0], 2 * y - before[1] - after[1]];
            const length = Math.hypot(...away);
            if (length < 4) away = [after[1] - y, x - after[0]].map(one => -one);
            const scale = 13 / (Math.hypot(...away) || 1);
            const [dx, dy] = away.map(one => one * scale);
            picture.append(svg("text", { class: "angle", x: (x + dx).toFixed(1), y: (y + dy + 3).toFixed(1), "text-anchor": dx > 4 ? "start" : dx < -4 ? "end" : "middle" }, degrees(angles[i])));
        });
        const parts = [made("figcaption", { class: "keys" },
            reported.length ? made("span", { class: "reported" }, "reported") : null, commanded.length ? made("span", { class: "commanded" }, "commanded") : null), picture];
        find("figure", element).replaceChildren(...parts);
        const rows = [];
        for (let i = 0; i !== Math.max(reported.length, commanded.length, speeds.length); ++i) {
            const text = values => values[i] === undefined ? "" : degrees(values[i]);
            rows.push([String(i + 1), { text: text(reported), class: "number" }, { text: text(commanded), class: "number" }, { text: speeds[i] === undefined ? "" : degrees(speeds[i]) + "/s", class: "number" }]);
        }
        fill(find("tbody", element), rows);
    }

    // ---- Buses

    const state_text = state => state || "unknown";
    function draw_buses() {
        const place = find("#live-buses");
        place.hidden = buses.length === 0;
        const known = new Map([...place.children].map(element => [element.dataset.bus, element]));
        buses.slice(0, 16).forEach(bus => {
            let element = known.get(bus.name);
            known.delete(bus.name);
            if (!element) {
                const slaves = table_of("Slaves", ["Position", "Name", "Station", "State", "AL status", "#Invalid frames", "#Forwarded errors", "#Lost links", "Served"]);
                slaves.className = "slaves";
                const histogram = table_of("Lateness of the cycles", ["Up to", "#Cycles", "Share, logarithmic"]);
                histogram.className = "histogram";
                element = made("div", { class: "bus", "data-bus": bus.name }, made("h2", {}, `Bus ${bus.name}`), made("dl"),
                    made("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": `Slaves of ${bus.name}` }, slaves),
                    made("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": `Lateness of the cycles of ${bus.name}` }, histogram));
                place.append(element);
            }
            draw_bus(element, bus);
        });
        for (const element of known.values()) element.remove();
    }
    function draw_bus(element, bus) {
        const counter = bus.working_counter, clock = bus.clock;
        const facts = [["State", state_text(bus.state), bus.state === "op" ? "" : "bad"]];
        if (bus.period_us !== undefined) facts.push(["Period", `${number_text(bus.period_us)} µs`]);
        if (bus.cycles !== undefined) facts.push(["Cycles", String(bus.cycles)]);
        if (counter) facts.push(["Working counter", `${counter.last ?? "none"} of ${counter.expected ?? "?"}`, counter.last === counter.expected ? "" : "bad"], ["Wrong", plural(counter.wrong ?? 0, "cycle"), counter.wrong ? "bad" : ""]);
        if (bus.frames_lost !== undefined) facts.push(["Frames lost", String(bus.frames_lost), bus.frames_lost ? "bad" : ""]);
        if (clock) facts.push(["Clock", [clock.reference === undefined ? "" : `of ${clock.reference}`, clock.offset_ns === undefined ? "" : `${clock.offset_ns} ns off`, clock.in_step === undefined ? "" : clock.in_step ? "in step" : "not in step"].filter(Boolean).join(", "), clock.in_step === false ? "bad" : ""]);
        const list = find("dl", element);
        while (list.children.length > facts.length) list.lastElementChild.remove();
        facts.forEach(([name, text, kind = ""], i) => {
            const entry = list.children[i] ?? list.appendChild(made("div", {}, made("dt"), made("dd")));
            set_text(entry.firstChild, name);
            set_text(entry.lastChild, text);
            set_class(entry.lastChild, kind);
        });
        const count = value => ({ text: value === undefined ? "" : String(value), class: value ? "number bad" : "number" });
        fill(find(".slaves tbody", element), (bus.slaves ?? []).map(slave => [
            String(slave.position ?? ""), slave.name ?? "", { text: String(slave.station ?? ""), class: "id" },
            { text: state_text(slave.state) + (slave.wanted && slave.wanted !== slave.state ? `, wanted ${slave.wanted}` : ""), class: slave.wanted && slave.wanted !== slave.state ? "bad" : "" },
            { text: slave.al_status ?? "", class: slave.al_status ? "bad" : "" },
            count(slave.errors?.invalid_frames), count(slave.errors?.forwarded), count(slave.errors?.lost_links),
            { text: [slave.in_service === undefined ? "" : slave.in_service ? "yes" : "no", slave.at_rest ? "at rest" : ""].filter(Boolean).join(", "), class: slave.in_service === false ? "bad" : "" },
        ]));
        find(".slaves", element).parentElement.hidden = !bus.slaves?.length;
        find(".slaves", element).classList.toggle("without-counters", !bus.slaves?.some(slave => slave.errors));
        const { upper_us: upper = [], counts = [] } = bus.histogram ?? {};
        const total = counts.reduce((sum, one) => sum + one, 0), most = Math.max(1, ...counts);
        const body = find(".histogram tbody", element);
        body.parentElement.parentElement.hidden = total === 0;
        fill(body, counts.map((one, i) => [i < upper.length ? `${upper[i]} µs` : `over ${upper.at(-1)} µs`, { text: String(one), class: "number" }, { text: "", class: "bar" }]));
        counts.forEach((one, i) => {
            const cell = body.rows[i].cells[2];
            if (!cell.firstChild) cell.append(made("span", { "aria-hidden": "true" }));
            cell.firstChild.style.width = `${(100 * Math.log1p(one) / Math.log1p(most)).toFixed(1)}%`;
        });
    }

    // ---- Who is there, faults, the program

    function draw_who() {
        fill(find("#live-systems tbody"), systems.slice(0, most_rows).map(one => [{ text: String(one.subsystem ?? ""), class: "id" }, one.name ?? "", { text: one.address ?? "", class: "id" },
            one.alive === undefined ? "" : one.alive ? { text: "alive", class: "good" } : { text: "silent", class: "bad" }]));
        const told = one => Object.fromEntries(Object.entries(one).filter(([, value]) => value !== ""));
        const all = components.map(one => one.own ? one : { ...senders.get(one.id), ...told(one) });
        const listed = new Set(components.map(one => one.id));
        for (const one of senders.values()) if (!listed.has(one.id)) all.push({ ...one, age: Math.max(0, at - one.heard_at) });
        const is_old = reported_at => reported_at !== undefined && at - reported_at > old_state;
        const age_of = reported_at => is_old(reported_at) ? `, ${seconds_text(at - reported_at)} ago` : "";
        fill(find("#live-components tbody"), all.slice(0, most_rows).map(one => [{ text: String(one.id ?? ""), class: "id" }, (one.name ?? "") + (one.own ? " (own)" : ""),
            { text: (one.state ?? "") + age_of(one.state_at), class: is_old(one.state_at) ? "" : { ready: "good", emergency: "bad", failure: "bad" }[one.state] ?? "" },
            one.controller ? { text: one.controller + (one.authority === undefined ? "" : ` (authority ${one.authority})`) + age_of(one.controller_at), class: "controller" } : one.own ? "none" : "",
            { text: one.age === undefined ? "" : one.own ? "" : `${seconds_text(one.age)} ago`, class: "number" }]));
        for (const [id, list] of [["#live-systems", systems], ["#live-components", all]]) find(id).parentElement.hidden = list.length === 0;
    }

    const levels = { info: 0, warning: 1, bad: 2 };
    const level_names = { info: "note", warning: "warning", bad: "fault" };
    let fault_shown = null; // the newest one that is in the list
    function draw_faults() {
        const list = find("#live-faults"), least = Number(find("#live-level").value);
        const fits = fault => (levels[fault.level] ?? 2) >= least;
        const from = fault_shown === null ? -1 : faults.indexOf(fault_shown);
        list.parentElement.setAttribute("aria-live", from < 0 ? "off" : "polite"); // only what is new is read out
        if (from < 0) list.replaceChildren(); // another program, or so many at once that none is left
        for (const fault of faults.slice(from + 1)) {
            if (!fits(fault)) continue;
            const time = new Date(at_received - (at - fault.at) * 1000);
            list.prepend(made("li", { class: fault.level ?? "bad" }, made("span", { class: "time", title: `${number_text(fault.at)} s since the program began` }, Number.isNaN(time.getTime()) ? "" : time.toTimeString().slice(0, 8)),
                made("span", { class: "level" }, level_names[fault.level] ?? "fault"), made("span", {}, fault.text ?? "")));
        }
        while (list.children.length > most_faults) list.lastElementChild.remove();
        fault_shown = faults.at(-1) ?? null;
        find("#live-no-faults").hidden = list.children.length > 0;
        list.hidden = list.children.length === 0;
    }
    function draw_program() {
        if (!program) return;
        find("#live-shown").hidden = false;
        const facts = [`${program.program ?? "program"} ${program.version ?? ""}`.trim(), program.name ? `system ${program.name}` : "", `running for ${seconds_text(at)}`];
        if (state_age) facts.push(`state of nodes and buses ${seconds_text(state_age)} old: their thread does nothing`);
        if (lost) facts.push(`${plural(lost, "message")} not shown: faster than they were read`);
        if (skipped) facts.push(`${plural(skipped, "update")} left out: this page was too slow`);
        set_text(find("#live-program"), facts.filter(Boolean).join(" · "));
        draw_title();
    }
    const draw = { messages: draw_messages, plot: draw_plot, arms: draw_arms, buses: draw_buses, who: draw_who, faults: draw_faults, program: draw_program };

    // ---- The connection

    let wanted = null; // {address, token} to which the page is connected, or tries to
    let socket = null, timer = 0, silence = 0, was_connected = false;

    function set_state(state) {
        root.dataset.state = state;
        find("#live-connect").textContent = wanted ? "Disconnect" : "Connect";
    }
    function disconnect() {
        clearTimeout(timer);
        wanted = null;
        const old = socket;
        socket = null;
        old?.close();
        set_state(program ? "lost" : "none");
    }
    function connect(address, token) {
        disconnect();
        wanted = { address, token };
        was_connected = false;
        set_state(program ? "lost" : "none");
        tell(`Connecting to ${address}.`);
        attempt();
    }
    function attempt() {
        let own = null;
        try {
            own = new WebSocket(`${location.protocol === "https:" && location.host === wanted.address ? "wss" : "ws"}://${wanted.address}/live${wanted.token ? "?token=" + encodeURIComponent(wanted.token) : ""}`);
        } catch (error) {
            disconnect();
            return tell(`${find("#live-address").value} is no address: 127.0.0.1:8080 is one.`);
        }
        socket = own;
        own.addEventListener("message", event => {
            if (socket !== own || typeof event.data !== "string") return;
            let frame = null;
            try { frame = JSON.parse(event.data); } catch { return tell("The program has sent what is no JSON."); }
            if (frame === null || typeof frame !== "object") return;
            if (frame.hello) was_connected = true;
            heard(own);
            if (frame.hello || root.dataset.state !== "connected") {
                set_state("connected");
                tell(`Connected to ${(frame.hello ?? program)?.program ?? "a program"} at ${wanted.address}.`);
            }
            take(frame);
        });
        own.addEventListener("close", () => {
            if (socket !== own || !wanted) return;
            if (root.dataset.state === "connected") tell(`Connection to ${wanted.address} lost at ${new Date().toTimeString().slice(0, 8)}. What is shown is the last state. Trying again every second.`);
            else if (!was_connected) tell(`No connection to ${wanted.address}: is the program running with --web, and is the token right? Trying again every second.`);
            set_state(program ? "lost" : "none");
            timer = setTimeout(attempt, retry_after);
        });
    }
    /** A connection may stay although the program is suspended or the cable is out: what is shown is old then. */
    function heard(own) {
        clearTimeout(silence);
        silence = setTimeout(() => {
            if (socket !== own || root.dataset.state !== "connected") return;
            tell(`${wanted.address} has sent nothing for ${silent_after / 1000} s. What is shown is the last state.`);
            set_state("lost");
        }, silent_after);
    }
    /** An address, or the link that a program prints. */
    function read_address() {
        const text = find("#live-address").value.trim();
        let address = text, token = find("#live-token").value.trim();
        if (/^\w+:\/\//.test(text)) {
            try {
                const link = new URL(text);
                address = link.host;
                token = link.searchParams.get("token") ?? token;
            } catch { return null; }
        }
        if (/^\d+$/.test(address)) address = "127.0.0.1:" + address;
        return /^[\w.[\]:-]+$/.test(address) ? { address, token } : null;
    }

    // ---- The two views

    const title = document.title;
    function draw_title() {
        const text = document.body.dataset.view === "live" && program ? `${program.name || program.program}: live (JausCat)` : title;
        if (document.title !== text) document.title = text;
    }

    function show_view(view) {
        document.body.dataset.view = view;
        for (const name of ["messages", "live"]) {
            find(`#tab-${name}`).setAttribute("aria-selected", name === view);
            find(`#tab-${name}`).tabIndex = name === view ? 0 : -1;
            find("#" + name).hidden = name !== view;
        }
        find(".skip").hidden = view === "live";
        draw_title();
        if (view === "live") {
            const address = wanted?.address ?? find("#live-address").value.trim();
            history.replaceState(null, "", location.pathname + location.search + "#view=live" + (address && !is_served ? "&address=" + encodeURIComponent(address) : ""));
            due("plot");
        } else if (document.documentElement.dataset.ready === "true") {
            keep_state();
        }
    }
    function restore_view() {
        const state = new URLSearchParams(location.hash.slice(1));
        const view = state.get("view") === "live" || !has_module || is_served && !location.hash ? "live" : "messages";
        if (state.get("address") && !is_served) find("#live-address").value = state.get("address");
        if (view !== document.body.dataset.view) show_view(view);
    }

    // A program serves the page as "/"; elsewhere it is a file with a name.
    const is_served = /^https?:$/.test(location.protocol) && location.pathname === "/";

    function start_live() {
        draw_head();
        for (const name of ["messages", "live"]) find(`#tab-${name}`).addEventListener("click", () => show_view(name));
        rove(find(".views"), "button");
        find("#live-form").addEventListener("submit", event => {
            event.preventDefault();
            if (wanted) {
                disconnect();
                return tell("Not connected.");
            }
            const read = read_address();
            if (!read) return tell(`${find("#live-address").value.trim() || "An empty field"} is no address: 127.0.0.1:8080 is one.`);
            find("#live-address").value = read.address;
            find("#live-token").value = read.token;
            connect(read.address, read.token);
            show_view("live");
        });
        find("#live-messages tbody").addEventListener("click", event => {
            const row = event.target.closest("tr");
            if (!row) return;
            chosen = chosen === row.dataset.key ? "" : row.dataset.key;
            draw_messages();
        });
        find("#live-filter").addEventListener("input", () => due("messages"));
        find("#live-level").addEventListener("change", () => { fault_shown = null; due("faults"); });
        find("#live-pause").addEventListener("click", () => paused_at === null ? pause() : resume());
        find("#live-clear").addEventListener("click", () => { series = []; next_colour = 0; resume(); due("messages"); });
        for (const type of ["pointermove", "pointerleave"]) find("#live-panels").addEventListener(type, point_at);
        addEventListener("resize", () => due("plot"));
        addEventListener("hashchange", restore_view);
        if (!has_module) {
            find(".views").hidden = true;
            find("#without-module").hidden = false;
        }
        restore_view();
        if (is_served) {
            find("#live-address").value = location.host;
            find("#live-token").value = new URLSearchParams(location.search).get("token") ?? "";
            connect(location.host, find("#live-token").value);
        }
        if (!has_module) document.documentElement.dataset.ready = "true";
    }
    start_live();
    return { take, state: () => ({ series: series.length, messages: messages.size, faults: faults.length, paused: paused_at !== null }) };
})();
