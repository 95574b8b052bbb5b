#!/usr/bin/python3
"""page_test.py [--page FILE] [--pictures FOLDER] [--jausdump PROGRAM] [NAME...]

Tests the page in a real browser without a window. NAME: a part of the names of the tests to run; all of them without.

  tests/web/page_test.py --page build/web/jauscat.html --pictures build/web/pictures link

Exit code: 0 all passed, 1 a test failed, 2 wrong command line.
"""
import argparse
import base64
import json
import pathlib
import struct
import subprocess
import sys

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

sys.dont_write_bytecode = True
from browser import contrast, page, root, run_tests, test, unnamed_controls # noqa: E402

data = root / "tests" / "data"

wrench = "0602050401210202012001010500220041000040" + "20"
request_control = "02001100062102020103" + "04feff0d00232200"


def vectors(file):
    return [json.loads(line) for line in (data / file).read_text().splitlines()]


def packed(stamp):
    """The integer of a time stamp or a date stamp; None of anything else."""
    for fields in ({"Milliseconds": 0, "Seconds": 10, "Minutes": 16, "Hour": 22, "Day": 27}, {"Day": 0, "Month": 5, "Year": 9}):
        if set(stamp) == set(fields):
            return sum(stamp[name] << bit for name, bit in fields.items())
    return None


def leaves(value):
    """The values in wire order: of scaled fields their integers, of a variant what it holds."""
    if isinstance(value, dict):
        if "raw" in value:
            return [value["raw"]]
        if packed(value) is not None:
            return [packed(value)]
        return [leaf for name, inner in value.items() if name != "index" for leaf in leaves(inner)]
    if isinstance(value, list):
        return [leaf for inner in value for leaf in leaves(inner)]
    return [value]


def raws(value):
    """The integers of all scaled fields."""
    if isinstance(value, dict):
        return [value["raw"]] if "raw" in value else [raw for inner in value.values() for raw in raws(inner)]
    return [raw for inner in value for raw in raws(inner)] if isinstance(value, list) else []


def lit(p):
    """The fields that are lit, by place: the paths of leaves of the tree, and the bytes of each strip."""
    return p.run("""
        const lit = [...document.querySelectorAll('.lit')];
        return {tree: lit.filter(one => one.matches('.leaf')).map(one => one.dataset.path),
                strips: [...document.querySelectorAll('.strip')].map(strip =>
                    [...strip.querySelectorAll('.part.lit .octet')].map(one => one.textContent).join(' '))};""")


@test
def pasted_bytes_become_a_tree_and_coloured_bytes(p):
    p.open()
    p.paste(wrench)
    p.until(lambda: p.text("#result h2") == "Set Wrench Effort")
    assert p.text("#result .title code") == "0405h"
    assert "1.1.32.1 → 2.2.33.1" in p.text(".facts"), p.text(".facts")
    told = p.run("return [...document.querySelectorAll('.leaf')].map(one => one.getAttribute('aria-label'))")
    assert "propulsive_linear_effort_x: 50.001526 % (raw 16384); bytes 18 to 19" in told, told
    octets = p.run("return [...document.querySelectorAll('#result .octet')].map(one => one.textContent).join('')")
    assert octets == wrench, octets
    assert "Set Wrench Effort, 21 bytes" in p.text("#status")
    colours = p.run("""return ['code', 'component', 'node', 'subsystem', 'instance', 'size', 'body-1'].map(kind =>
        getComputedStyle(document.querySelector('#result .part.' + kind + ' .octet')).backgroundColor)""")
    assert len(set(colours)) == 7, colours
    p.picture("message")


@test
def a_field_and_its_bytes_light_up_together(p):
    p.open("hex=" + wrench)
    leaf = p.find(".leaf[data-path='propulsive_linear_effort_x'] .line")
    ActionChains(p.driver).move_to_element(leaf).perform()
    p.until(lambda: lit(p)["tree"] == ["propulsive_linear_effort_x"])
    assert lit(p)["strips"] == ["00 40"] * 4, lit(p)  # message, packet, frame, message again
    component = p.find("#result .part.component")
    ActionChains(p.driver).move_to_element(component).perform()
    p.until(lambda: lit(p)["tree"] == ["destination.component"])
    assert lit(p)["strips"] == ["21", "15 1b 00 00", "15 1b", "21"], lit(p)
    assert "destination.component = 33" in p.text(".readout")


@test
def a_message_passes_every_mapping_table_and_comes_back(p):
    p.open()
    tables = p.run("return jauscat.catalogue.tables")
    assert len(tables) == 8, tables
    for one in tables:
        message, generation = (request_control, "sae") if one["table"] == "sae" else (wrench, "ra")
        p.open(f"hex={message}&table={one['table']}&base={one['base']}")
        assert p.run("return [table.value, Number(base.value)]") == [one["table"], one["base"]], one
        assert p.find("#again [data-same]").get_attribute("data-same") == "true", one
        index = int(p.text("#object").split("h:")[0], 16)
        assert index - one["base"] == 33, (one, index)
        # The packet and the frame, pasted, are the message again.
        shown = p.run("return shown.stages")
        for stage in (shown["packet"]["hex"], "\n".join(frame["hex"] for frame in shown["frames"])):
            p.paste(stage)
            wanted = message[2:] if generation == "sae" else message
            if one["table"] == "seed" and stage != shown["packet"]["hex"]:
                wanted = message[:14] + "00" + message[16:]  # the subsystem is not on the wire
            p.until(lambda: p.run("return input.messages[0]?.bytes") == wanted, f"{one}: {stage}")
    p.open("hex=" + wrench + "&table=self-contained")
    p.picture("stages")


@test
def an_error_names_the_field_and_the_byte(p):
    p.open("hex=" + wrench[:-4])
    told = p.text("#fault")
    assert "truncated" in told and "propulsive_linear_effort_x at byte 18" in told, told
    fault = p.find("#fault")
    assert (fault.get_attribute("data-field"), fault.get_attribute("data-byte")) == ("propulsive_linear_effort_x", "18")
    assert p.run("return [...document.querySelectorAll('.octet.bad')].map(one => one.textContent)") == ["00"]
    p.picture("error")
    for text, wanted in (("0602 05x4", "not a hex digit at column 8"), ("060", "odd number of hex digits"),
                         (wrench + "ff", "trailing bytes after the last field at byte 21"), ("0602ffff" + wrench[8:], "command code 0xFFFF"),
                         ("0504 0100 ff", "propulsive_linear_effort_x at byte 4 needs 2 bytes, 1 left")):  # a payload of SAE
        p.paste(text)
        p.until(lambda: wanted in p.text("#fault"), f"{text}: {wanted}")


def pcapng(file):
    """A capture of pcap as one of pcapng, with nanoseconds."""
    content = file.read_bytes()
    link_type = struct.unpack("<I", content[20:24])[0]

    def block(kind, body):
        body += b"\0" * (-len(body) % 4)
        return struct.pack("<II", kind, len(body) + 12) + body + struct.pack("<I", len(body) + 12)

    made = block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1))
    made += block(1, struct.pack("<HHI", link_type, 0, 0) + struct.pack("<HHB3xHH", 9, 1, 9, 0, 0))
    at = 24
    while at < len(content):
        seconds, micros, size, whole = struct.unpack("<IIII", content[at:at + 16])
        ticks = seconds * 10**9 + micros * 1000
        made += block(6, struct.pack("<IIIII", 0, ticks >> 32, ticks & 0xFFFFFFFF, size, whole) + content[at + 16:at + 16 + size])
        at += 16 + size
    return made


def dropped(p, name, content):
    p.run("""
        const bytes = Uint8Array.from(atob(arguments[1]), c => c.charCodeAt(0));
        const files = new DataTransfer();
        files.items.add(new File([bytes], arguments[0]));
        document.querySelector('main').dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: files}));
    """, name, base64.b64encode(content).decode())


@test
def a_capture_is_opened_or_dropped(p):
    p.open()
    p.find("#file").send_keys(str(data / "jaus_ra.pcap"))
    p.until(lambda: "3329 messages in 3342 packets" in p.text("#status"), p.text("#status"))
    assert len(p.all("#list button")) == 500
    assert "13 × not UDP: IP protocol 1" in p.text("#skipped"), p.text("#skipped")
    messages = p.run("return input.messages")
    if p.jausdump:
        lines = subprocess.run([p.jausdump, "--format", "json", data / "jaus_ra.pcap"], capture_output=True, text=True).stdout
        assert same_messages(messages, [json.loads(line) for line in lines.splitlines()])
    p.find("#filter").send_keys("global pose")
    p.until(lambda: 0 < len(p.all("#list button")) < 500)
    row = p.find("#list button")
    row.click()
    p.until(lambda: "Global Pose" in p.text("#result h2"))
    p.picture("capture")
    for name, content in (("sae.pcapng", pcapng(data / "sae_management.pcap")), ("sae.pcap", (data / "sae_management.pcap").read_bytes())):
        dropped(p, name, content)
        p.until(lambda: f"{name}: 22 messages" in p.text("#status"), p.text("#status"))
        times = p.run("return input.messages.map(message => message.origin.time)")
        assert times[0].startswith("2011-"), times[0]
        assert name == "sae.pcapng" or times == before, (times, before)
        before = times
    dropped(p, "bus.pcap", (data / "ethercat_jauscat_seed.pcap").read_bytes())
    p.until(lambda: "bus.pcap" in p.text("#status"))
    names = p.run("return input.messages.map(message => message.message)")
    assert {"Set Wrench Effort", "Query Wrench Effort", "Report Wrench Effort"} <= set(names), names
    dropped(p, "cut.pcap", (data / "sae_management.pcap").read_bytes()[:-3])
    p.until(lambda: "ends inside a packet" in p.text("#status"))
    dropped(p, "noise.bin", bytes(range(256)))
    p.until(lambda: "is no capture" in p.text("#status"))
    dropped(p, "lines.txt", f"{wrench}\n{wrench}\n".encode())
    p.until(lambda: len(p.all("#list button")) == 2)


def same_messages(ours, theirs):
    for i, (one, other) in enumerate(zip(ours, theirs)):
        for key in other:
            assert one[key] == other[key], (i, key, one, other)
    return len(ours) == len(theirs)


@test
def a_message_is_built_from_its_form(p):
    p.open()
    p.find("#tab-fields").click()
    box = p.find("#type")
    box.clear()
    box.send_keys("Set Wrench Effort", Keys.TAB)
    entry = "#form [aria-label='Include propulsive_linear_effort_x']"
    p.until(lambda: p.all(entry))
    if not p.find(entry).is_selected():
        p.find(entry).click()
    value = p.run("return document.querySelector(arguments[0]).closest('.entry').querySelector('input[type=text]')", entry)
    value.clear()
    value.send_keys("-100")
    p.until(lambda: "0180" in p.run("return input.messages[0].bytes"))
    assert p.text("#result h2") == "Set Wrench Effort"
    value.clear()
    value.send_keys("150")
    p.until(lambda: "must be -100 to 100" in p.text("#form-error"), p.text("#form-error"))
    assert value.get_attribute("aria-invalid") == "true"
    assert p.find("#form-error").get_attribute("data-field") == "fields.propulsive_linear_effort_x"
    p.picture("form")
    value.clear()
    value.send_keys("25 %")
    p.until(lambda: not p.find("#form-error").is_displayed())
    # A list, and a value in a form that a type selects.
    box.clear()
    box.send_keys("Set Joint Efforts", Keys.TAB)
    add = "//button[text()='Add to joint']"
    p.until(lambda: p.driver.find_elements(By.XPATH, add))
    p.driver.find_element(By.XPATH, add).click()
    p.driver.find_element(By.XPATH, add).click()
    p.until(lambda: len(p.run("return shown.fields.joint ?? []")) == 2, json.dumps(p.run("return shown.fields")))
    # SAE alike.
    Select(p.find("#generation")).select_by_value("sae")
    box.send_keys("RequestControl", Keys.TAB)
    p.until(lambda: p.text("#result h2") == "RequestControl")
    assert p.run("return input.messages[0].generation") == "SAE"
    box.clear()
    box.send_keys("no such message", Keys.TAB)
    p.until(lambda: "There is no message" in p.text("#type-error"))


@test
def a_link_restores_the_page(p):
    p.open("hex=" + wrench)
    Select(p.find("#table")).select_by_value("self-contained")
    Select(p.find("#base")).select_by_value(str(0x2000))
    p.find(".leaf[data-path='destination.node'] .line").click()
    p.find("#tab-fields").click()
    link = p.driver.current_url
    before = p.run("return [result.innerText, stages.innerText, document.querySelector('#form').innerText]")
    p.open()
    p.driver.get("about:blank")
    p.driver.get(link)
    p.until(lambda: p.run("return document.documentElement.dataset.ready") == "true")
    assert p.run("return [result.innerText, stages.innerText, document.querySelector('#form').innerText]") == before
    assert p.find("#tab-fields").get_attribute("aria-selected") == "true"
    assert lit(p)["tree"] == ["destination.node"]
    assert p.run("return [table.value, base.value]") == ["self-contained", str(0x2000)]
    p.run("location.hash = 'hex=' + arguments[0]", request_control)  # as by the browser's back button
    p.until(lambda: p.text("#result h2") == "RequestControl")


@test
def dark_and_light_schemes_have_contrast(p):
    backgrounds = []
    for scheme in ("light", "dark"):
        p.scheme(scheme)
        p.open("hex=" + wrench[:-4])
        backgrounds.append(p.run("return getComputedStyle(document.documentElement).backgroundColor"))
        for selector in ("h1", ".top p", "#text", ".help", "#fault", ".facts", ".part .label", ".octet", ".leaf .name", ".leaf .at", "footer p",
                         ".part.code .octet", ".part.node .octet", ".part.body-0 .octet", ".readout", ".tabs button[aria-selected=false]"):
            ratio = contrast(p, selector)
            assert ratio >= 4.5, (scheme, selector, ratio)
        p.open("hex=" + wrench)
        p.picture(scheme)
    p.scheme("light")
    assert backgrounds[0] != backgrounds[1], backgrounds


@test
def a_narrow_screen_needs_no_sideways_scrolling(p):
    longest = max((one["hex"] for one in vectors("ra_vectors.jsonl")), key=len)
    p.size(320, 640)
    try:
        for state in ("hex=" + wrench, "hex=" + longest, "hex=" + wrench + "&view=fields", "hex=" + longest + "&view=fields", "hex=" + wrench + "." + request_control):
            p.open(state)
            wide = p.run("""return [...document.querySelectorAll('body *')].filter(one => one.getBoundingClientRect().right > 320.5 && one.offsetParent && !one.closest('pre'))
                .map(one => one.tagName + '.' + one.className + ' ' + one.textContent.slice(0, 40))""")
            assert p.run("return document.documentElement.scrollWidth") <= 320, (state[:60], wide[:5])
        p.open("hex=" + wrench)
        p.picture("narrow")
        p.open("hex=" + wrench + "&view=fields")
        p.picture("narrow-form")
    finally:
        p.size(1000, 900)


@test
def everything_can_be_done_by_the_keyboard(p):
    p.open()
    focus = "return document.activeElement.id || document.activeElement.className"

    def tab_to(wanted, most=60):
        for _ in range(most):
            if p.run("return document.activeElement.matches(arguments[0])", wanted):
                return
            p.keys(Keys.TAB)
        raise AssertionError(f"Tab does not get to {wanted}; focus is at {p.run(focus)}")

    tab_to("#text")
    other = wrench[:-2] + "ff"  # not the one that is shown
    ActionChains(p.driver).key_down(Keys.CONTROL).send_keys("a").key_up(Keys.CONTROL).send_keys(other).perform()
    p.until(lambda: p.run("return input.messages[0]?.bytes") == other)
    tab_to("#result .part")
    p.keys(Keys.ARROW_RIGHT)
    p.until(lambda: lit(p)["tree"] == ["command_code"], lit(p))
    p.keys(Keys.END)
    p.until(lambda: lit(p)["tree"] == ["resistive_linear_effort_x"], lit(p))
    p.keys(Keys.ENTER)
    p.until(lambda: "field=resistive_linear_effort_x" in p.driver.current_url)
    tab_to("[role=treeitem]")
    p.keys(Keys.ARROW_LEFT)  # closes the header
    assert p.run("return document.activeElement.getAttribute('aria-expanded')") == "false"
    p.keys(Keys.ARROW_DOWN, Keys.ARROW_DOWN)
    p.until(lambda: lit(p)["tree"] == ["presence_vector"], lit(p))
    tab_to("#table")
    p.keys(Keys.ARROW_DOWN)
    p.until(lambda: p.run("return table.value") == "self-contained")
    p.run("document.activeElement.blur()")
    p.open("hex=" + wrench)
    tab_to("#tab-bytes")
    p.keys(Keys.ARROW_RIGHT, Keys.ENTER)
    p.until(lambda: p.find("#view-fields").is_displayed())
    tab_to("#form input[type=checkbox]")
    p.keys(Keys.SPACE)
    p.until(lambda: "propulsive" not in json.dumps(p.run("return shown.fields")))


@test
def every_control_has_a_name_and_results_are_announced(p):
    for state in ("hex=" + wrench, "hex=" + wrench + "&view=fields", "hex=" + request_control + "." + wrench + "&view=fields"):
        p.open(state)
        seen, unnamed = unnamed_controls(p)
        assert unnamed == [], (state[-40:], unnamed)
        assert seen > 40, seen
    assert p.find("#status").get_attribute("aria-live") == "polite"
    assert p.run("return document.documentElement.lang") == "en"
    assert len(p.all("h1")) == 1
    ids = p.run("return [...document.querySelectorAll('[id]')].map(one => one.id)")
    assert len(ids) == len(set(ids)), sorted(one for one in ids if ids.count(one) > 1)


golden = """
const [vectors, generation, is_payload] = arguments;
return vectors.map(hex => {
    const shown = jauscat.show({hex, generation, is_payload});
    const fields = shown.presence_vector == null ? shown.fields ?? {} : {presence_vector: Number(shown.presence_vector), ...shown.fields};
    const again = is_payload ? shown.body : jauscat.make({generation, code: shown.code, header: shown.header, fields}).hex;
    const covered = shown.parts.reduce((at, part) => part.offset === at ? at + part.size : NaN, 0);
    return {fields: shown.fields, header: shown.header, presence_vector: shown.presence_vector, error: shown.error, again, covered};
});"""


def exact(value):
    """The value with integers that JavaScript would round as text."""
    if isinstance(value, dict):
        return {name: exact(inner) for name, inner in value.items()}
    if isinstance(value, list):
        return [exact(inner) for inner in value]
    return str(value) if isinstance(value, int) and abs(value) > 1 << 53 else value


def checked_golden(p, file, generation, arguments):
    known = vectors(file)
    lines = [one["hex"] for one in known]
    told = []
    for at in range(0, len(lines), 200):
        told += p.run(golden, lines[at:at + 200], generation, generation == "sae")
    assert len(told) == len(known) > 1000
    dumped = [None] * len(known)
    if p.jausdump:
        result = subprocess.run([p.jausdump, "--format", "json", *arguments], input="\n".join(lines), capture_output=True, text=True)
        dumped = [json.loads(line) for line in result.stdout.splitlines()]
        assert len(dumped) == len(known)
    for vector, one, other in zip(known, told, dumped):
        assert one.get("error") is None, (vector, one)
        assert one["again"] == vector["hex"], (vector, one)
        assert one["covered"] == len(vector["hex"]) // 2, (vector, one)
        if other:
            for key in ("fields", "presence_vector"):
                assert one[key] == exact(other[key]), (key, one, other)
        yield vector, one


@test
def every_golden_message_of_ra_3_3_has_its_known_values(p):
    p.open()
    for vector, one in checked_golden(p, "ra_vectors.jsonl", "ra", []):
        header = dict(one["header"])
        assert int(vector["code"], 16) == header.pop("command_code")
        wanted = vector["header"]
        assert {key: int(value) if not isinstance(value, dict) else value for key, value in header.items()} == wanted, (header, wanted)
        assert one["presence_vector"] == vector["presence_vector"], vector
        numbers = [leaf for leaf in leaves(vector["fields"]) if isinstance(leaf, int)]
        ours = leaves(one["fields"])
        for number in numbers:  # those beyond 2^53 as text, which JavaScript keeps
            assert "interface_type_codes" in vector or number in ours or str(number) in ours, (number, vector, one)


@test
def every_golden_message_of_sae_has_its_known_values(p):
    p.open()
    for vector, one in checked_golden(p, "sae_vectors.jsonl", "sae", ["--sae"]):
        ours = leaves(one["fields"])
        for number in raws(vector["fields"]):
            assert number in ours, (number, vector, one)


@test
def a_form_filled_by_a_message_makes_its_bytes(p):
    p.open()
    script = """
        const [vectors, generation] = arguments;
        return vectors.map(hex => {
            const is_payload = generation === 'sae';
            const shown = jauscat.show({hex, generation, is_payload});
            if (shown.fields === undefined) return hex; // an acknowledgement without a body
            const message = jauscat.catalogue.messages.find(one => one.generation === generation && one.code === shown.code);
            build_form(message, shown);
            const answer = jauscat.make({generation, code: message.code, header: form.header.get('header'), fields: form.fields.get('fields')});
            // A flag that announces a field of each element has no control: without elements it says nothing.
            const same = answer.hex && JSON.stringify(jauscat.show({hex: answer.hex, generation, is_payload: false}).fields) === JSON.stringify(shown.fields);
            return same ? hex : answer.hex ?? JSON.stringify(answer);
        });"""
    for file, generation in (("ra_vectors.jsonl", "ra"), ("sae_vectors.jsonl", "sae")):
        lines = [one["hex"] for one in vectors(file)]
        made = []
        for at in range(0, len(lines), 100):
            made += p.run(script, lines[at:at + 100], generation)
        for hex, got in zip(lines, made):
            if generation == "sae" and got != hex:  # a datagram: version, header, payload, sequence number
                got = got[26:-4]
            assert got == hex, (generation, hex, got)


@test
def the_page_needs_no_network_and_reports_no_error(p):
    p.open()
    assert p.run("return performance.getEntriesByType('resource').map(one => one.name)") == []
    complaints = [entry for entry in p.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]
    assert complaints == [], complaints


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--page", type=pathlib.Path, default=root / "build/web/jauscat.html")
    parser.add_argument("--pictures", type=pathlib.Path, default=root / "build/web/pictures")
    parser.add_argument("--jausdump")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    p = page(options.page, options.pictures)
    p.jausdump = options.jausdump
    return run_tests(p, options.names)


if __name__ == "__main__":
    sys.exit(main())
