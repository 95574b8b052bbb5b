"use strict";
// The page: reads and makes messages by the module (module.cpp), shows them, and keeps its state in the link.

const find = (selector, within = document) => within.querySelector(selector);
const all = (selector, within = document) => [...within.querySelectorAll(selector)];

/** An element with attributes and children; attributes that begin with "on" are listeners, null and false are left out. */
function made(name, attributes = {}, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (value === null || value === undefined || value === false) continue;
        if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
        else element.setAttribute(key, value === true ? "" : value);
    }
    element.append(...children.filter(child => child !== null && child !== undefined));
    return element;
}
const say = text => { find("#status").textContent = text; };
const plural = (count, one, many = one + "s") => `${count} ${count === 1 ? one : many}`;
const hex_code = code => code.toString(16).toUpperCase().padStart(4, "0") + "h";

// ---- The module

const jauscat = {};

async function load_module() {
    const packed = Uint8Array.from(atob(module_gzip), c => c.charCodeAt(0));
    if (typeof DecompressionStream === "undefined")
        throw new Error("this browser is too old: DecompressionStream is missing (Chromium 80, Firefox 113, Safari 16.4)");
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
    const imports = {};
    let memory = null;
    const view = () => new DataView(memory.buffer);
    const functions = {
        environ_sizes_get(count, size) { view().setUint32(count, 0, true); view().setUint32(size, 0, true); return 0; },
        environ_get: () => 0,
        proc_exit(code) { throw new Error(`the module has ended with ${code}`); },
        emscripten_notify_memory_growth() {},
    };
    for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
        imports[from] ??= {};
        imports[from][name] = kind === "tag" ? new WebAssembly.Tag({ parameters: ["i32"] }) : functions[name] ?? (() => 8); // no such file
    }
    const { exports } = await WebAssembly.instantiate(module, imports);
    memory = exports.memory;
    exports._initialize?.();

    const put = bytes => new Uint8Array(memory.buffer).set(bytes, exports.jauscat_memory(bytes.length));
    const text_at = at => {
        const bytes = new Uint8Array(memory.buffer);
        return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
    };
    const ask = name => request => {
        const bytes = new TextEncoder().encode(JSON.stringify(request));
        put(bytes);
        return JSON.parse(text_at(exports[name](bytes.length)));
    };
    for (const name of ["forms", "read", "show", "make", "capture_begin"]) jauscat[name] = ask("jauscat_" + name);
    jauscat.catalogue = JSON.parse(text_at(exports.jauscat_catalogue()));
    jauscat.capture_packet = (link_type, seconds, nanoseconds, bytes) => {
        put(bytes);
        return exports.jauscat_capture_packet(link_type, seconds, nanoseconds, bytes.length) !== 0;
    };
    jauscat.capture_end = () => JSON.parse(text_at(exports.jauscat_capture_end()));
}

// ---- Captures: the file formats pcap and pcapng. What is in the packets, the module knows.

class capture_error extends Error {}

/** Calls packet(link_type, seconds, nanoseconds, bytes) for each packet of a file. */
function* packets_of(buffer) {
    const data = new DataView(buffer), size = buffer.byteLength;
    const magic = size >= 4 ? data.getUint32(0, true) : 0;
    const bytes = (at, length) => {
        if (at + length > size) throw new capture_error("the capture ends inside a packet");
        return new Uint8Array(buffer, at, length);
    };
    if (magic === 0x0A0D0D0A) return yield* blocks_of(data, size, bytes);
    const swapped = { 0xA1B2C3D4: [true, 1000], 0xA1B23C4D: [true, 1], 0xD4C3B2A1: [false, 1000], 0x4D3CB2A1: [false, 1] }[magic];
    if (!swapped || size < 24) throw new capture_error("no capture: neither pcap nor pcapng");
    const [little, unit] = swapped;
    const link_type = data.getUint32(20, little) & 0xFFFF;
    for (let at = 24; at + 16 <= size;) {
        const length = data.getUint32(at + 8, little);
        yield { link_type, seconds: data.getUint32(at, little), nanoseconds: data.getUint32(at + 4, little) * unit, bytes: bytes(at + 16, length), at };
        at += 16 + length;
    }
}
function* blocks_of(data, size, bytes) {
    let little = true, interfaces = [];
    for (let at = 0; at + 12 <= size;) {
        const section = data.getUint32(at, true) === 0x0A0D0D0A;
        if (section) {
            little = data.getUint32(at + 8, true) === 0x1A2B3C4D;
            interfaces = [];
        }
        const type = data.getUint32(at, little), length = data.getUint32(at + 4, little);
        if (length < 12 || at + length > size) throw new capture_error("the capture ends inside a block");
        if (type === 1) interfaces.push({ link_type: data.getUint16(at + 8, little), ticks: ticks_of(data, at + 16, at + length - 4, little) });
        const on = number => {
            if (!interfaces[number]) throw new capture_error("a packet of an interface that the capture does not describe");
            return interfaces[number];
        };
        if (type === 6) {
            const { link_type, ticks } = on(data.getUint32(at + 8, little));
            const time = BigInt(data.getUint32(at + 12, little)) << 32n | BigInt(data.getUint32(at + 16, little));
            yield { link_type, seconds: Number(time / ticks), nanoseconds: Number(time % ticks * 1000000000n / ticks), bytes: bytes(at + 28, data.getUint32(at + 20, little)), at };
        } else if (type === 3) {
            const { link_type } = on(0);
            yield { link_type, seconds: 0, nanoseconds: 0, bytes: bytes(at + 12, Math.min(data.getUint32(at + 8, little), length - 16)), at };
        }
        at += length;
    }
}
/** Ticks of a second, by the option if_tsresol. */
function ticks_of(data, at, end, little) {
    while (at + 4 <= end) {
        const code = data.getUint16(at, little), length = data.getUint16(at + 2, little);
        if (code === 9) {
            const power = data.getUint8(at + 4);
            return power & 0x80 ? 1n << BigInt(power & 0x7F) : 10n ** BigInt(power);
        }
        if (code === 0) break;
        at += 4 + (length + 3 & ~3);
    }
    return 1000000n;
}

async function read_capture(buffer, name) {
    jauscat.capture_begin(table_request());
    let count = 0, problem = "";
    const strange = new Set();
    try {
        for (const { link_type, seconds, nanoseconds, bytes, at } of packets_of(buffer)) {
            if (!jauscat.capture_packet(link_type, seconds, nanoseconds, bytes)) strange.add(link_type);
            if (++count % 2000 === 0) {
                say(`Reading ${name}: ${Math.round(100 * at / buffer.byteLength)} %`);
                await new Promise(resolve => setTimeout(resolve));
            }
        }
    } catch (error) {
        if (!(error instanceof capture_error)) throw error;
        problem = error.message;
    }
    const read = jauscat.capture_end();
    if (strange.size) problem ||= `link type ${[...strange].join(", ")} is not supported: Ethernet, Linux cooked, raw IP and loopback are`;
    return { ...read, packets: count, problem };
}

// ---- Colours: by the field of the header, as in the picture of the README; fields of the body in four tints

function kind_of(part, index) {
    const path = part.fields[0]?.path ?? "";
    if (part.place === "body") return path === "message_id" ? "code" : "body-" + index % 4;
    if (path === "command_code") return "code";
    const destination = path.match(/^destination\.(\w+)$/);
    if (destination) return destination[1];
    if (path === "data_size" || path === "size") return "size";
    return "plain";
}
const text_of = part => part.fields.map(field => `${field.path} = ${field.value}`).join(", ");
const label_of = part => (part.fields[0]?.path ?? part.place ?? "").replace(/^.*\./, "").replaceAll("_", " ");
const place_of = (offset, size) => size === 1 ? `byte ${offset}` : `bytes ${offset} to ${offset + size - 1}`;
const octets_of = hex => hex.match(/../g) ?? [];

const roved = new WeakSet();
/** Arrow keys, Home and End move among the items of a container; one of them is in the order of Tab. */
function rove(container, selector) {
    const items = () => all(selector, container).filter(item => item.offsetParent !== null);
    const first = find(selector, container);
    all(selector, container).forEach(item => { item.tabIndex = item === first ? 0 : -1; });
    if (roved.has(container)) return;
    roved.add(container);
    container.addEventListener("focusin", event => {
        const item = event.target.closest(selector);
        if (item) all(selector, container).forEach(other => { other.tabIndex = other === item ? 0 : -1; });
    });
    container.addEventListener("keydown", event => {
        const list = items(), at = list.indexOf(event.target.closest(selector));
        const next = { ArrowRight: at + 1, ArrowDown: at + 1, ArrowLeft: at - 1, ArrowUp: at - 1, Home: 0, End: list.length - 1 }[event.key];
        if (at < 0 || next === undefined || event.defaultPrevented || !list[next]) return;
        event.preventDefault();
        list[next].focus();
    });
}

// ---- A message. These functions need nothing of the page but what they get, so that what is live can use them.

const hint = "Point at a byte or a field: both light up, at every stage.";
const most_octets = 512; // of a strip; the rest on demand

/** A strip of bytes. `parts`: offset, size, fields; `key`: the place of a part among `of`, the parts of the message. */
function strip_of({ title, facts, hex, parts, key, kind, of, fault }) {
    const octets = octets_of(hex);
    const figure = made("figure", { class: "strip", style: "margin-left:0;margin-right:0" });
    const bytes = made("div", { class: "bytes", role: "group", "aria-label": `${title}: bytes by field; arrow keys move, Enter keeps a field marked` });
    figure.append(made("figcaption", {}, made("strong", {}, title), facts ?? ""), bytes);
    const gaps = [];
    let at = 0;
    for (const part of parts) {
        if (part.offset > at) gaps.push({ offset: at, size: part.offset - at, fields: [], place: "" });
        gaps.push(part);
        at = Math.max(at, part.offset + part.size);
    }
    if (at < octets.length) gaps.push({ offset: at, size: octets.length - at, fields: [], place: fault === undefined ? "" : "not decoded" });
    // The field at fault, and what is not decoded from there on.
    const is_bad = (part, at) => fault !== undefined && (part.fields.length === 0 ? at >= fault : part.offset <= fault && fault < part.offset + part.size);
    const append = (from, to) => {
        for (const part of gaps) {
            if (part.size === 0 || part.offset < from || part.offset >= to) continue;
            const number = key(part);
            const octet = (byte, i) => made("span", { class: "octet" + (is_bad(part, part.offset + i) ? " bad" : "") }, byte);
            const own = octets.slice(part.offset, part.offset + part.size);
            const named = part.fields.length === 0 && number !== null ? of[number] : part;
            const value = text_of(named) || label_of(part) || "no field";
            bytes.append(made("button", {
                type: "button", class: "part" + (number === null ? "" : " " + kind(number)), "data-part": number,
                "aria-label": `${value}; ${place_of(part.offset, part.size)}: ${own.slice(0, 16).join(" ")}${own.length > 16 ? " …" : ""}`,
                "data-told": value, "data-at": place_of(part.offset, part.size),
            }, made("span", { class: "label", "aria-hidden": "true" }, label_of(named)),
                made("span", { class: "octets", "aria-hidden": "true" }, ...(unused(part, own) ? [made("span", { class: "octet many" }, `${own.length} × 00`)] : own.map(octet)))));
        }
    };
    // The unused end of a mailbox is not shown byte by byte.
    const unused = (part, own) => part.fields.length === 0 && key(part) === null && own.length > 8 && own.every(byte => byte === "00");
    append(0, most_octets);
    if (octets.length > most_octets)
        bytes.append(made("button", { type: "button", class: "small more", onclick: event => {
            event.currentTarget.remove();
            append(most_octets, Infinity);
            rove_items(bytes);
        } }, `${octets.length - most_octets} more bytes`));
    const rove_items = strip => rove(strip, ".part, .more");
    rove_items(bytes);
    return figure;
}

/** The tree of a message: places (header, body), then the fields by their paths. */
function tree_of(parts, kind) {
    const root = made("ul", { class: "tree", role: "tree", "aria-label": "Fields; arrow keys move" });
    const branches = new Map();
    const branch = (path, name, within, depth, place) => {
        if (!branches.has(path)) {
            const inside = made("ul", { role: "group" });
            within.append(made("li", { role: "treeitem", class: place ? "branch place" : "branch", "aria-expanded": "true", tabindex: "-1", style: `--depth:${depth}`, "data-branch": path },
                made("div", { class: "line" }, made("span", { class: "name" }, name), made("span", { class: "value" }), made("span", { class: "at" })), inside));
            branches.set(path, inside);
        }
        return branches.get(path);
    };
    const names = { header: "Header", body: "Fields", sequence: "Behind the fields" };
    parts.forEach((part, index) => {
        for (const field of part.fields) {
            let within = branch(part.place, names[part.place] ?? part.place, root, 0, true), path = part.place, depth = 1;
            const steps = field.path.match(/[^.[\]]+|\[\d+\]/g) ?? [field.path];
            steps.slice(0, -1).forEach(step => {
                path += "." + step;
                within = branch(path, step, within, depth++, false);
            });
            within.append(made("li", { role: "treeitem", class: "leaf " + kind(index), tabindex: "-1", "data-part": index, "data-path": field.path, style: `--depth:${depth}`,
                "aria-label": `${field.path}: ${field.value}; ${place_of(part.offset, part.size)}` },
            made("div", { class: "line" },
                made("span", { class: "name" }, made("span", { class: "swatch" }), steps.at(-1)),
                made("span", { class: "value" }, field.value),
                made("span", { class: "at" }, part.size > 1 ? `${part.offset}–${part.offset + part.size - 1}` : `${part.offset}`))));
        }
    });
    const set = (item, expanded) => item.setAttribute("aria-expanded", expanded);
    root.addEventListener("click", event => {
        const line = event.target.closest(".line"), item = line?.parentElement;
        if (item?.classList.contains("branch")) set(item, item.getAttribute("aria-expanded") !== "true");
        item?.focus();
    });
    root.addEventListener("keydown", event => {
        const item = event.target.closest("[role=treeitem]");
        if (!item || !["ArrowLeft", "ArrowRight", "Enter", " "].includes(event.key)) return;
        const expanded = item.getAttribute("aria-expanded"), right = event.key === "ArrowRight";
        if (event.key === "Enter" || event.key === " ") {
            if (expanded !== null) event.preventDefault(), set(item, expanded !== "true");
        } else if (expanded !== null && (expanded === "true") !== right) {
            event.preventDefault();
            set(item, right);
        } else if (!right) {
            event.preventDefault();
            item.parentElement.closest("[role=treeitem]")?.focus();
        }
    });
    rove(root, "[role=treeitem]");
    return root;
}

const id_text = (id, generation) => [id.subsystem, id.node, id.component, ...(generation === "ra" ? [id.instance] : [])].join(".");
function facts_of(shown, hex) {
    const facts = [plural(hex.length / 2, "byte")];
    if (shown.header) {
        const size = shown.header.sequence_number ?? shown.sequence_number;
        facts.push(`${id_text(shown.header.source, shown.generation)} → ${id_text(shown.header.destination, shown.generation)}`);
        if (size !== undefined) facts.push(`sequence ${size}`);
    }
    return (shown.generation === "ra" ? "RA 3.3 · " : "SAE · ") + facts.join(" · ");
}

/** Shows a message: `message` is one of jauscat.read, `shown` what jauscat.show says of it. */
function show_message(container, message, shown) {
    const kind = kinds_of(shown.parts);
    container.replaceChildren(
        made("div", { class: "title" }, made("h2", {}, shown.name ?? message.message ?? "Not a message"),
            shown.code === undefined ? null : made("code", {}, hex_code(shown.code))),
        made("p", { class: "facts" }, facts_of(shown, message.bytes)));
    const error = message.error ?? shown.error;
    const fault = shown.error?.byte ?? message.error?.byte;
    if (error) container.append(made("p", { class: "wrong", role: "alert", id: "fault", "data-field": error.field, "data-byte": error.byte }, error.text ?? error.error));
    if (message.refusal) container.append(made("p", { class: "wrong" }, `Refused: ${message.refusal.what} ${message.refusal.code}: ${message.refusal.text}`));
    if (message.data_set) container.append(made("p", { class: "help" }, `Message of several packets: ${message.data_set}`));
    container.append(
        strip_of({ title: message.is_payload ? "Payload" : "Message", facts: "", hex: message.bytes, parts: shown.parts, key: part => { const at = shown.parts.indexOf(part); return at < 0 ? null : at; }, kind, of: shown.parts, fault: error ? fault : undefined }),
        made("p", { class: "readout", "aria-hidden": "true" }, hint),
        tree_of(shown.parts, kind));
    const copies = made("details", { class: "tools" }, made("summary", {}, "As JSON"),
        made("pre", { tabindex: "0" }, JSON.stringify({ message: shown.name, code: message.code, header: shown.header, sequence_number: shown.sequence_number, presence_vector: shown.presence_vector, fields: shown.fields, error: error ?? undefined }, null, 2)));
    container.append(copies);
}
/** The class of the colour of each part of a message. */
function kinds_of(parts) {
    let body = 0;
    const kinds = parts.map(part => kind_of(part, part.place === "body" && part.fields[0]?.path !== "message_id" ? body++ : 0));
    return index => kinds[index] ?? "";
}

/** Shows the stages of a message, of jauscat.show. */
function show_stages(container, message, shown) {
    const stages = shown.stages, kind = kinds_of(shown.parts), key = part => part.from ?? null;
    const wrong = error => made("p", { class: "wrong" }, error.text);
    const strip = (title, facts, stage) => made("div", { class: "stage" }, strip_of({ title, facts, hex: stage.hex, parts: stage.parts, key, kind, of: shown.parts }));
    container.replaceChildren();
    if (!stages || stages.error) return container.append(wrong(stages?.error ?? { text: "no table" }));
    const packet = stages.packet;
    container.append(strip("SDO download packet", `${plural(packet.hex.length / 2, "byte")}; each row of the table makes a field`, packet));
    if (stages.object.error) return container.append(wrong(stages.object.error));
    const { station, index, subindex } = stages.object;
    container.append(made("div", { class: "stage" }, made("p", { class: "stage-title" }, made("strong", {}, "Object"), `${plural(stages.object.hex.length / 2, "byte")} of data`),
        made("p", { class: "object", id: "object" }, `${hex_code(index)}:${subindex} of station ${station}`)));
    stages.frames.forEach((frame, i) => container.append(strip("EtherCAT frame", (stages.frames.length > 1 ? `${i + 1} of ${stages.frames.length}, ` : "") + plural(frame.hex.length / 2, "byte") + ", as the slave returns it", frame)));
    const again = stages.message;
    const last = made("div", { class: "stage", id: "again" });
    container.append(last);
    if (again.error) return last.append(wrong(again.error));
    const same = again.hex === message.bytes;
    last.append(strip_of({ title: "Message again", facts: "what the slave makes of the object, by the same rows", hex: again.hex, parts: shown.parts.map((part, from) => ({ ...part, from })), key, kind, of: shown.parts }),
        made("p", { class: same ? "same" : "wrong", "data-same": String(same) }, same ? "The same, byte for byte." : "Not the same bytes."));
}

// ---- The form of a message

let controls = new Map(); // by path, of the values read last
let next_id = 0;

/** Controls for one form of the module: {element, get(path), set(value)}. `scope`: the structures around it. */
const makers = {
    structure: (form, name, scope) => structure_control(form.of, name, scope),
    list(form, name, scope) {
        const items = made("div"), parts = [];
        const add = value => {
            const control = control_of(form.element, `${name}[${parts.length}]`, scope);
            const row = made("div", { class: "item" }, control.element);
            if (form.least !== form.most) row.append(made("button", { type: "button", class: "small", "aria-label": `Remove element of ${name}`, onclick: () => { parts.splice(parts.indexOf(part), 1); row.remove(); changed(items); } }, "Remove"));
            const part = { control, row };
            parts.push(part);
            items.append(row);
            if (value !== undefined) control.set(form.field ? value[form.field] : value);
        };
        const element = made("fieldset", {}, made("legend", {}, name), items);
        if (form.least !== form.most) element.append(made("button", { type: "button", class: "small", onclick: () => { add(); changed(items); } }, `Add to ${name}`));
        for (let i = 0; i < form.least; ++i) add();
        return {
            element,
            get: path => parts.map(({ control }, i) => { const value = control.get(`${path}[${i}]`); return form.field ? { [form.field]: value } : value; }),
            set(value) { parts.splice(0); items.replaceChildren(); value.forEach(add); },
        };
    },
    tree(form, name, scope) {
        const node = depth => {
            const inner = control_of(hidden_member(form.element, form.children), "node", scope), children = [], items = made("div");
            const add = value => {
                const child = node(depth + 1), row = made("div", {}, child.element);
                row.append(made("button", { type: "button", class: "small", onclick: () => { children.splice(children.indexOf(child), 1); row.remove(); changed(items); } }, "Remove node"));
                children.push(child);
                items.append(row);
                if (value) child.set(value);
            };
            const element = made("fieldset", {}, made("legend", {}, depth === 1 ? name : "child"), inner.element, items);
            if (depth < form.depth) element.append(made("button", { type: "button", class: "small", onclick: () => { add(); changed(items); } }, "Add a child"));
            return {
                element,
                get: path => ({ ...inner.get(path), child: children.map((child, i) => child.get(`${path}.child[${i}]`)) }),
                set({ child, ...value }) { inner.set(value); children.splice(0); items.replaceChildren(); (child ?? []).forEach(add); },
            };
        };
        const root = node(1);
        return { ...root, set: value => value && root.set(value) };
    },
    choice(form, name, scope, member) {
        const place = made("div");
        let held = null, tag = null;
        const follow = () => {
            const wanted = scope.number_of(member.tag);
            if (wanted === tag) return;
            tag = wanted;
            const found = form.cases.find(one => one.tag === tag);
            held = found?.form ? { form: found.form, control: control_of(found.form, name, scope) } : null;
            place.replaceChildren(held ? held.control.element : made("p", { class: "help" }, found ? `${name} has no value here.` : `${name}: the type has no known value.`));
        };
        scope.followers.push(follow);
        return {
            element: place,
            get: path => { follow(); return held ? held.form.kind === "structure" ? held.control.get(path) : { value: held.control.get(path) } : {}; },
            set(value) { follow(); if (held && value) held.control.set(held.form.kind === "structure" ? value : value.value); },
        };
    },
    variant(form, name, scope) {
        const select = made("select", { id: `c${++next_id}` }, ...form.alternatives.map(one => made("option", {}, one.name)));
        const place = made("div");
        let held = null;
        const pick = () => {
            const one = form.alternatives[select.selectedIndex];
            held = one.form ? control_of(one.form, one.name, scope) : null;
            place.replaceChildren(...(held ? [held.element] : []));
        };
        select.addEventListener("change", pick);
        pick();
        return {
            element: made("fieldset", {}, made("legend", {}, name), made("label", { for: select.id, class: "inline" }, "Alternative ", select), place),
            get: path => ({ [select.value]: held ? held.get(`${path}.${select.value}`) : {} }),
            set(value) { const [alternative, inner] = Object.entries(value)[0]; select.value = alternative; pick(); held?.set(inner); },
        };
    },
    flags(form, name) {
        const boxes = form.names.map((bit, i) => bit ? made("input", { type: "checkbox", id: `c${++next_id}`, "data-bit": i }) : null).filter(Boolean);
        let other = 0n;
        const element = made("div", { class: "entry", role: "group", "aria-label": name }, made("span", { class: "name" }, name),
            made("div", { class: "value" }, ...boxes.map(box => made("label", { class: "flag", for: box.id }, box, form.names[box.dataset.bit]))));
        if (!boxes.length) return simple_control(form, name);
        return {
            element,
            get(path) { controls.set(path, element); return boxes.reduce((sum, box) => sum | (box.checked ? 1n << BigInt(box.dataset.bit) : 0n), other).toString(); },
            set(value) {
                const bits = BigInt(value);
                other = bits;
                for (const box of boxes) {
                    box.checked = (bits >> BigInt(box.dataset.bit) & 1n) === 1n;
                    other &= ~(1n << BigInt(box.dataset.bit));
                }
            },
            number: () => Number(boxes.reduce((sum, box) => sum | (box.checked ? 1n << BigInt(box.dataset.bit) : 0n), other)),
        };
    },
};

/** The element's structure without the member that counts its children. */
function hidden_member(form, children) {
    if (form.kind !== "structure" || !children) return form;
    return { ...form, of: { ...form.of, members: form.of.members.filter(member => member.name !== children.name) } };
}

const notes = {
    scaled: form => `${shorter(form.min)} to ${shorter(form.max)}${form.unit ? " " + form.unit : ""}`,
    real: form => form.unit,
    number: form => [form.signed ? `${form.bits} bits, signed` : `${form.bits} bits`, form.unit].filter(Boolean).join(", "),
    text: form => form.most > 4294967294 ? "text" : form.least === form.most ? `${form.most} characters` : `at most ${form.most} characters`,
    bytes: () => "hex",
    message: () => "header and body, in hex",
    packed: form => form.has_notation ? "notation or integer" : `${form.bits} bits`,
};
const shorter = number => Math.abs(number) >= 1e6 || number === 0 ? number.toPrecision(4).replace(/\.?0+($|e)/, "$1") : String(+number.toPrecision(6));

/** A value of one control. */
function simple_control(form, name) {
    const id = `c${++next_id}`;
    let control, raw = null;
    if (form.kind === "enumeration") {
        control = made("select", { id }, ...form.names.map((one, i) => one ? made("option", { value: i }, `${one} (${i})`) : null));
    } else if (form.kind === "boolean") {
        control = made("input", { id, type: "checkbox" });
    } else {
        const numeric = ["scaled", "real", "number", "flags"].includes(form.kind);
        control = made("input", { id, type: "text", inputmode: numeric && !(form.signed || form.kind !== "number") ? "numeric" : null, autocomplete: "off", spellcheck: "false" });
        if (form.kind === "scaled") control.value = form.min <= 0 && form.max >= 0 ? "0" : shorter(form.min);
        else if (numeric || form.kind === "packed") control.value = "0";
        control.addEventListener("input", () => { raw = null; });
    }
    const note = notes[form.kind]?.(form) ?? "";
    const note_id = `${id}n`;
    if (note) control.setAttribute("aria-describedby", note_id);
    return {
        element: made("div", { class: "entry" }, made("label", { for: id }, name), made("div", { class: "value" }, control, note ? made("span", { class: "note", id: note_id }, note) : null)),
        get(path) {
            controls.set(path, control);
            if (form.kind === "boolean") return control.checked ? "1" : "0";
            if (raw !== null) return raw;
            return control.value === "" && !["text", "bytes", "message"].includes(form.kind) ? undefined : control.value;
        },
        set(value) {
            raw = null;
            if (form.kind === "boolean") control.checked = value !== 0 && value !== false;
            else if (form.kind === "scaled") control.value = typeof value === "object" ? String(+value.value.toPrecision(8)) : value, raw = value;
            else if (value !== null && typeof value === "object") control.value = "", raw = value; // text that is not UTF-8
            else control.value = String(value);
            if (form.kind === "enumeration" && control.selectedIndex < 0) {
                control.append(made("option", { value }, String(value)));
                control.value = String(value);
            }
        },
        number: () => form.kind === "boolean" ? Number(control.checked) : Number(control.value),
    };
}
function control_of(form, name, scope, member) {
    return (makers[form.kind] ?? simple_control)(form, name, scope, member);
}

/** All members of a structure but those that follow from others: counts, and flags that announce what is elsewhere. */
function structure_control(type, name, outer, skip = []) {
    const parts = new Map();
    const scope = {
        followers: outer?.followers ?? [],
        derived: outer?.derived ?? derived_members(type),
        number_of(reference) {
            if (reference.owner !== type.id) return outer?.number_of(reference);
            return parts.get(reference.name)?.control.number?.();
        },
    };
    const element = made("fieldset", { class: outer ? null : "outer" }, name ? made("legend", {}, name) : null);
    for (const member of type.members) {
        if (skip.includes(member.name) || scope.derived.has(`${type.id}.${member.name}`)) continue;
        const part = { control: control_of(member.form, member.name, scope, member), present: () => true };
        parts.set(member.name, part);
        if (member.optional) {
            const box = made("input", { type: "checkbox", "aria-label": `Include ${member.name}` }); // a value that is typed includes it, too
            const place = part.control.element;
            const show = () => place.classList.toggle("absent", !box.checked);
            const label = find(":scope > label, :scope > .name, :scope > legend", place);
            label ? label.before(box) : place.prepend(box);
            if (label && place.classList.contains("entry")) {
                const line = made("span", { class: "inline" });
                box.before(line);
                line.append(box, label);
            }
            box.addEventListener("change", show);
            place.addEventListener("input", event => { if (event.target !== box && !box.checked) box.checked = true, show(); });
            show();
            part.present = () => box.checked;
            part.include = included => { box.checked = included; show(); };
        }
        element.append(part.control.element);
    }
    return {
        element,
        get(path) {
            const value = {};
            for (const [member, part] of parts) {
                if (!part.present()) continue;
                const got = part.control.get(path ? `${path}.${member}` : member);
                if (got !== undefined) value[member] = got;
            }
            return value;
        },
        set(value) {
            for (const [member, part] of parts) {
                const has = value && value[member] !== undefined && value[member] !== null;
                part.include?.(has);
                if (has) part.control.set(value[member]);
                scope.followers.forEach(follow => follow());
            }
        },
    };
}
function derived_members(type, found = new Set()) {
    const visit = form => {
        if (!form) return;
        if (form.of) derived_members(form.of, found);
        [form.element, ...(form.cases ?? []).map(one => one.form), ...(form.alternatives ?? []).map(one => one.form)].forEach(visit);
    };
    for (const member of type.members) {
        // Where a list may be absent, its count does not follow from it.
        const counter = member.optional && !member.gate ? null : member.counter;
        for (const reference of [counter, member.gate]) if (reference) found.add(`${reference.owner}.${reference.name}`);
        visit(member.form);
    }
    return found;
}

let form = null; // {message, header, fields, number, followers}

function changed(element) { element.dispatchEvent(new Event("input", { bubbles: true })); }

/** Makes the form of a message; `shown` fills it. */
function build_form(message, shown) {
    const told = jauscat.forms({ generation: message.generation, code: message.code });
    const computed = message.generation === "sae" ? ["size", "compression", "message_type"] : ["command_code", "data_size"];
    const fields = structure_control(told.fields, "", null, message.generation === "sae" ? ["message_id"] : []);
    const header = structure_control(told.header, "", null, computed);
    const number = message.generation === "sae" ? simple_control({ kind: "number", bits: 16 }, "sequence_number") : null;
    const start = message.generation === "sae"
        ? { destination: { component: 33, node: 2, subsystem: 258 }, source: { component: 35, node: 4, subsystem: 260 } }
        : { destination: { instance: 1, component: 33, node: 2, subsystem: 2 }, source: { instance: 1, component: 32, node: 1, subsystem: 1 } };
    header.set({ ...told.defaults, ...start });
    if (shown?.header) header.set(shown.header);
    if (shown?.fields) fields.set(shown.fields);
    if (number && shown?.sequence_number !== undefined) number.set(shown.sequence_number);
    form = { message, header, fields, number };
    find("#form").replaceChildren(
        told.fields.members.length ? fields.element : made("p", { class: "help" }, "The message has no fields."),
        made("details", { id: "header-form" }, made("summary", {}, "Header: addresses, priority, acknowledgement"), header.element, number?.element));
    if (!fields.element.querySelector("input, select, button")) fields.element.append(made("p", { class: "help" }, "The message has no fields."));
    find("#type").value = message.name;
}

function read_form() {
    if (!form) return;
    controls = new Map();
    const request = { generation: form.message.generation, code: form.message.code, fields: form.fields.get("fields"), header: form.header.get("header") };
    const number = form.number?.get("sequence_number");
    if (number !== undefined) request.sequence_number = Number(number) & 0xFFFF;
    const answer = jauscat.make(request);
    all("[aria-invalid]", find("#form")).forEach(one => one.removeAttribute("aria-invalid"));
    const error = find("#form-error");
    error.hidden = !answer.error;
    error.textContent = answer.error ?? "";
    if (answer.error) {
        let path = answer.field ?? "";
        while (path && !controls.has(path)) path = path.replace(/(\.|\[)[^.[]*$/, "").replace(/^[^.[]*$/, "");
        controls.get(path)?.setAttribute("aria-invalid", "true");
        error.dataset.field = answer.field ?? "";
        return;
    }
    find("#text").value = spaced(answer.hex);
    read_text(find("#text").value, { keep_form: true });
}

// ---- The state of the page

let input = { messages: [], skipped: {} }; // of jauscat.read or a capture
let selected = -1, marked = null, from_capture = false;
let shown = null;

const spaced = hex => octets_of(hex).join(" ");
let ra_table = { table: "seed", base: 6900 }; // the table of RA 3.3 that was chosen last
const usual_frames = "seed/6900";
/** The table by which EtherCAT frames of the input are read: nothing in a frame tells it. */
function read_frames_by(wanted) {
    const frames = find("#frames");
    if ([...frames.options].some(one => one.value === wanted)) frames.value = wanted;
}
function table_request() {
    const [table, base] = find("#frames").value.split("/");
    return { table: find("#table").value || "seed", base: Number(find("#base").value || 6900), frames: { table, base: Number(base) } };
}
/** What to paste for a message: that of SAE is behind the version of a datagram. */
function pasted(message) {
    return spaced((message.generation === "SAE" && !message.is_payload ? "02" : "") + message.bytes);
}

function read_text(text, { keep_form = false, select = 0 } = {}) {
    from_capture = false;
    input = text.trim() ? jauscat.read({ ...table_request(), text }) : { messages: [], skipped: {} };
    if (input.packet && input.packet.error) input.skipped["SDO packet: " + input.packet.error.text] = 1;
    show_input(Math.min(select, input.messages.length - 1), keep_form);
}

function show_input(select, keep_form = false) {
    const { messages } = input;
    find("#records").hidden = messages.length < 2;
    find("#filter").value = "";
    if (messages.length >= 2) show_list();
    const skipped = Object.entries(input.skipped ?? {}).map(([reason, count]) => count === 1 ? reason : `${count} × ${reason}`);
    find("#skipped").textContent = skipped.length ? "Left out: " + skipped.join("; ") : "";
    choose(select, { keep_form });
    const bad = messages.filter(message => message.error).length;
    let told = messages.length === 0 ? find("#text").value.trim() || from_capture ? "No JAUS message." : "" : messages.length === 1 ? "" : `${plural(messages.length, "message")}${bad ? `, ${bad} with an error` : ""}.`;
    if (messages.length === 1) told = `${shown?.name ?? messages[0].message ?? "Not a message"}, ${plural(messages[0].bytes.length / 2, "byte")}${bad ? ": " + messages[0].error.text : ""}.`;
    if (messages.length < 2 && skipped.length) told += " Left out: " + skipped.join("; ") + ".";
    say(told);
}

const most_rows = 500;
function show_list() {
    const wanted = find("#filter").value.trim().toLowerCase();
    const ids = message => message.header ? `${id_text(message.header.source, message.generation === "SAE" ? "sae" : "ra")} → ${id_text(message.header.destination, message.generation === "SAE" ? "sae" : "ra")}` : "";
    const list = find("#list");
    let left = most_rows, count = 0;
    const rows = [];
    input.messages.forEach((message, i) => {
        const code = message.code ? message.code.replace("0x", "") + "h" : "–";
        const name = message.message ?? "not a message";
        if (wanted && !`${name} ${code} ${ids(message)}`.toLowerCase().includes(wanted)) return;
        ++count;
        if (left-- <= 0) return;
        rows.push(made("li", {}, made("button", { type: "button", "data-index": i, "aria-current": i === selected ? "true" : null, onclick: () => choose(i) },
            made("span", { class: "number" }, String(message.origin?.packet ?? message.origin?.line ?? i + 1)),
            made("span", { class: "code" }, code),
            made("span", { class: "name" + (message.error || message.refusal ? " bad" : "") }, name + (message.data_set ? ` (${message.data_set.replaceAll("_", " ")})` : "") + (message.error ? ": " + message.error.error.replaceAll("_", " ") : message.refusal ? ": refused" : "")),
            made("span", { class: "ids" }, ids(message)))));
    });
    list.replaceChildren(...rows);
    if (count > most_rows) list.append(made("li", { class: "help" }, `${count - most_rows} more: narrow the list by the filter.`));
    rove(list, "button");
    return count;
}

function choose(index, { keep_form = false } = {}) {
    selected = index;
    marked = null;
    const message = input.messages[index];
    all("#list [aria-current]").forEach(row => row.removeAttribute("aria-current"));
    find(`#list [data-index="${index}"]`)?.setAttribute("aria-current", "true");
    find("#result").hidden = find("#way").hidden = !message;
    shown = null;
    if (!message) return keep_state();
    if (from_capture) find("#text").value = pasted(message);
    const generation = message.generation === "SAE" ? "sae" : "ra";
    fill_tables(generation);
    show_chosen(message, generation);
    if (!keep_form && shown.type) {
        const known = jauscat.catalogue.messages.find(one => one.generation === generation && one.code === shown.code);
        find("#generation").value = generation;
        fill_types();
        build_form(known, shown);
    }
    keep_state();
}
function show_chosen(message, generation) {
    const whole = !message.is_payload && message.bytes.length >= 32;
    shown = jauscat.show({ hex: message.bytes, generation, is_payload: message.is_payload, ...(whole ? table_request() : {}) });
    show_message(find("#result"), message, shown);
    find("#way").hidden = !whole;
    if (whole) show_stages(find("#stages"), message, shown);
}

const table_names = { seed: "seed table", "self-contained": "self-contained table", sae: "table of SAE" };
const base_name = base => base === 6900 ? "6900 (1AF4h)" : hex_code(base);
function fill_tables(generation) {
    const of = jauscat.catalogue.tables.filter(one => (one.table === "sae") === (generation === "sae"));
    const table = find("#table"), names = [...new Set(of.map(one => one.table))];
    if (names.includes(table.value)) return fill_bases();
    table.replaceChildren(...names.map(name => made("option", { value: name }, table_names[name])));
    if (generation === "ra") table.value = ra_table.table;
    fill_bases(generation === "ra" ? ra_table.base : "");
}
function fill_bases(wanted = find("#base").value) {
    const bases = jauscat.catalogue.tables.filter(one => one.table === find("#table").value).map(one => one.base);
    find("#base").replaceChildren(...bases.map(base => made("option", { value: base }, base_name(base))));
    if (bases.includes(Number(wanted))) find("#base").value = wanted;
    if (find("#table").value !== "sae") ra_table = { table: find("#table").value, base: Number(find("#base").value) };
}
function fill_types() {
    const generation = find("#generation").value;
    const of = jauscat.catalogue.messages.filter(one => one.generation === generation);
    find("#types").replaceChildren(...of.map(one => made("option", { value: one.name }, hex_code(one.code))));
}

/** Lights what holds the same: bytes of all stages, and the field of the tree. */
function light(part) {
    all(".lit").forEach(one => one.classList.remove("lit"));
    const wanted = part ?? marked;
    const readout = find(".readout");
    if (readout) readout.replaceChildren(wanted === null ? hint : "");
    if (wanted === null) return;
    all(`[data-part="${wanted}"]`).forEach(one => one.classList.add("lit"));
    const bytes = find(`#result .part[data-part="${wanted}"]`);
    if (bytes && readout) readout.append(made("b", {}, bytes.dataset.told), ` · ${bytes.dataset.at}`);
}
function part_at(target) {
    const part = target.closest?.(".line")?.parentElement?.dataset.part ?? target.closest?.(".part")?.dataset.part ?? target.dataset?.part;
    return part === undefined ? null : Number(part);
}

function keep_state() {
    if (document.body.dataset.view === "live") return; // which has a link of its own
    const state = new URLSearchParams();
    const message = input.messages[selected];
    const text = from_capture && message ? pasted(message) : find("#text").value;
    const lines = text.trim().split(/\s*\n\s*/);
    const plain = lines.map(line => line.replaceAll(" ", ""));
    if (plain.every(line => /^[0-9a-fA-F]+$/.test(line))) { if (plain[0]) state.set("hex", plain.join(".")); }
    else if (text.trim()) state.set("text", text);
    if (!from_capture && selected > 0) state.set("message", selected);
    if (message && !find("#way").hidden && (find("#table").value !== "seed" && find("#table").value !== "sae")) state.set("table", find("#table").value);
    if (message && !find("#way").hidden && find("#base").selectedIndex > 0) state.set("base", find("#base").value);
    if (find("#frames").value !== usual_frames) state.set("frames", find("#frames").value);
    if (find("#tab-fields").getAttribute("aria-selected") === "true") state.set("view", "fields");
    if (marked !== null && shown) state.set("field", shown.parts[marked].fields[0]?.path ?? "");
    const link = state.toString();
    if (link.length < 60000) history.replaceState(null, "", link ? "#" + link : location.pathname + location.search);
}
function restore() {
    const state = new URLSearchParams(location.hash.slice(1));
    const is_live = state.get("view") === "live" || !location.hash;
    const text = state.get("text") ?? (state.get("hex") ?? (is_live ? examples[0][1].replaceAll(" ", "") : "")).split(".").map(spaced).join("\n");
    find("#text").value = text;
    fill_tables("ra");
    select_view(state.get("view") === "fields" ? "fields" : "bytes");
    const table = state.get("table"), base = state.get("base");
    if (table && [...find("#table").options].some(one => one.value === table)) find("#table").value = table;
    fill_bases(base ?? "");
    read_frames_by(usual_frames);
    read_frames_by(state.get("frames") ?? `${table ?? find("#table").value}/${base ?? find("#base").value}`);
    read_text(text, { select: Number(state.get("message") ?? 0) });
    if (base && find("#base").value !== base) { // of SAE, whose table is there only now
        fill_bases(base);
        reshow();
    }
    const path = state.get("field");
    if (path && shown) {
        const part = shown.parts.findIndex(one => one.fields.some(field => field.path === path));
        if (part >= 0) mark(part);
    }
}
function mark(part) {
    marked = marked === part ? null : part;
    light(null);
    keep_state();
}
function reshow() {
    const message = input.messages[selected];
    if (!message) return;
    show_chosen(message, message.generation === "SAE" ? "sae" : "ra");
    light(null);
    keep_state();
}

function select_view(view) {
    for (const name of ["bytes", "fields"]) {
        find(`#tab-${name}`).setAttribute("aria-selected", name === view);
        find(`#tab-${name}`).tabIndex = name === view ? 0 : -1;
        find(`#view-${name}`).hidden = name !== view;
    }
}

const examples = [
    ["Set Wrench Effort (RA 3.3)", "06 02 05 04 01 21 02 02 01 20 01 01 05 00 22 00 41 00 00 40 20"],
    ["Request Control (SAE)", "02 00 11 00 06 21 02 02 01 03 04 fe ff 0d 00 23 22 00"],
    ["A message that is cut off", "06 02 05 04 01 21 02 02 01 20 01 01 05 00 22 00 41 00 00"],
];

async function take_file(file) {
    if (document.body.dataset.view === "live") find("#tab-messages").click();
    say(`Reading ${file.name}.`);
    const buffer = await file.arrayBuffer();
    const start = new Uint8Array(buffer, 0, Math.min(4, buffer.byteLength)).join();
    const is_capture = ["212,195,178,161", "77,60,178,161", "161,178,195,212", "161,178,60,77", "10,13,13,10"].includes(start);
    if (!is_capture && new Uint8Array(buffer).some(byte => byte === 0 || byte > 127)) return say(`${file.name} is no capture: neither pcap nor pcapng nor text.`);
    select_view("bytes");
    if (!is_capture) {
        find("#text").value = new TextDecoder().decode(buffer);
        return read_text(find("#text").value);
    }
    const read = await read_capture(buffer, file.name);
    input = read;
    from_capture = true;
    find("#text").value = "";
    show_input(0);
    say(`${file.name}: ${plural(read.messages.length, "message")} in ${plural(read.packets, "packet")}${read.problem ? "; " + read.problem : ""}.`);
}

function start() {
    let waiting = 0;
    const soon = action => { clearTimeout(waiting); waiting = setTimeout(action, 120); };
    find("#text").addEventListener("input", event => soon(() => read_text(event.target.value)));
    find("#file").addEventListener("change", event => { if (event.target.files[0]) take_file(event.target.files[0]); event.target.value = ""; });
    find("#example").append(...examples.map(([name], i) => made("option", { value: i }, name)));
    find("#example").addEventListener("change", event => {
        const example = examples[event.target.value];
        if (example) find("#text").value = example[1], read_text(example[1]);
        event.target.value = "";
    });
    find("#filter").addEventListener("input", () => say(plural(show_list(), "message") + "."));
    for (const name of ["bytes", "fields"]) find(`#tab-${name}`).addEventListener("click", () => {
        select_view(name);
        if (name === "fields" && !form) {
            find("#generation").value = "ra";
            build_form(jauscat.catalogue.messages.find(one => one.type === "set_wrench_effort" && one.generation === "ra"));
        }
        if (name === "fields" && !input.messages.length) read_form();
        keep_state();
    });
    rove(find(".tabs"), "button");
    find("#generation").addEventListener("change", () => { fill_types(); find("#type").value = ""; find("#type").focus(); });
    find("#type").addEventListener("change", event => {
        const generation = find("#generation").value, wanted = event.target.value.trim().toLowerCase();
        const of = jauscat.catalogue.messages.filter(one => one.generation === generation);
        const found = of.find(one => [one.name.toLowerCase(), one.type, hex_code(one.code).toLowerCase(), hex_code(one.code).toLowerCase().slice(0, 4)].includes(wanted));
        const error = find("#type-error");
        error.hidden = Boolean(found) || !wanted;
        event.target.toggleAttribute("aria-invalid", !found && Boolean(wanted));
        if (!found && wanted) event.target.setAttribute("aria-invalid", "true");
        error.textContent = found ? "" : `There is no message '${event.target.value}' of this generation.`;
        if (found) build_form(found), read_form();
    });
    find("#form").addEventListener("input", () => soon(read_form));
    find("#form").addEventListener("change", () => soon(read_form));
    find("#form").addEventListener("submit", event => event.preventDefault());
    const choose_table = base => {
        fill_bases(base);
        read_frames_by(`${find("#table").value}/${find("#base").value}`);
        reshow();
    };
    find("#table").addEventListener("change", () => choose_table());
    find("#base").addEventListener("change", event => choose_table(event.target.value));
    find("#frames").append(...jauscat.catalogue.tables.map(one => made("option", { value: `${one.table}/${one.base}` }, `${table_names[one.table]}, ${base_name(one.base)}`)));
    find("#frames").addEventListener("change", () => { if (!from_capture) read_text(find("#text").value); else say("Open the capture again to read it by this table."); });
    document.addEventListener("pointerover", event => light(part_at(event.target)));
    document.addEventListener("focusin", event => light(part_at(event.target)));
    document.addEventListener("focusout", () => light(null));
    document.addEventListener("click", event => { const part = part_at(event.target); if (part !== null) mark(part); });
    document.addEventListener("keydown", event => {
        if (event.key === "Enter" && event.target.matches?.("[role=treeitem].leaf")) mark(part_at(event.target));
    });
    document.addEventListener("dragover", event => { event.preventDefault(); document.body.classList.add("dropping"); });
    document.addEventListener("dragleave", event => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
    document.addEventListener("drop", event => {
        event.preventDefault();
        document.body.classList.remove("dropping");
        if (event.dataTransfer.files[0]) take_file(event.dataTransfer.files[0]);
    });
    addEventListener("hashchange", restore);
    fill_types();
    if (!location.hash && document.body.dataset.view !== "live") location.replace("#hex=" + examples[0][1].replaceAll(" ", ""));
    restore();
    document.documentElement.dataset.ready = "true";
}

/** Without a module the page has the live view only (assemble.py). */
const has_module = module_gzip !== "";
if (has_module) load_module().then(start).catch(error => {
    say("");
    find("#status").replaceChildren(made("span", { class: "wrong" }, `The module does not run: ${error.message}`));
    document.documentElement.dataset.ready = "failed";
    throw error;
});
