#!/usr/bin/python3
"""pictures.py PROGRAMS [NAME...]: makes build/web/pictures/message.png, live.png and joints.png, for scripts/web-pictures."""
import base64
import math
import pathlib
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from browser import page, root # noqa: E402
from live_test import choose, robot, six_joints, watch # noqa: E402

programs = pathlib.Path(sys.argv[1]).resolve()
whole_page = root / "build/web/jauscat.html"
wide = 1200


def picture(p, name, first, last):
    """From the top of the element `first` to the bottom of `last`."""
    top = p.run("return document.querySelector(arguments[0]).getBoundingClientRect().top + scrollY", first)
    bottom = p.run("return document.querySelector(arguments[0]).getBoundingClientRect().bottom + scrollY", last)
    shot = p.driver.execute_cdp_cmd("Page.captureScreenshot", {
        "captureBeyondViewport": True, "clip": {"x": 0, "y": max(0, top - 16), "width": p.run("return innerWidth"), "height": bottom - top + 32, "scale": 1}})
    (p.pictures / f"{name}.png").write_bytes(base64.b64decode(shot["data"]))


def message(p):
    p.size(1000, 900)
    p.open("hex=0602050401210202012001010500220041000040" + "20&field=propulsive_linear_effort_x")
    p.run("document.querySelector('.tree .branch').setAttribute('aria-expanded', false); light(null)")
    picture(p, "message", "#result", "#stages .stage:nth-child(2)")


def live(p):
    """Efforts that change, for some 40 seconds."""
    p.size(wide, 900)
    watch(p)
    p.robot.command(propulsive_linear_effort_x=0, propulsive_linear_effort_y=0)
    choose(p, "set_wrench_effort", "1.1.32.1")
    for field in ("propulsive_linear_effort_x", "propulsive_linear_effort_y"):
        p.find(f'#live-fields [data-field="{field}"]').click()
    p.robot.stop("ocu")
    for step in range(80):
        values = [f"propulsive_linear_effort_x={60 * math.sin(step / 6):.1f}", f"propulsive_linear_effort_y={40 * math.cos(step / 4):.1f}"]
        subprocess.run([programs / "ocu", "--config", p.robot.config, "--this", "a", *values], check=True, stdout=subprocess.DEVNULL)
        time.sleep(0.4)
    picture(p, "live", "#live-status", "#live-plot")


def joints(p):
    """Six joints as they move."""
    p.size(wide, 700)
    before, p.robot = p.robot, six_joints(programs, whole_page)
    try:
        watch(p)
        # The picture stands still in the middle of the way.
        p.robot.move()
        choose(p, "report_joint_positions", "2.1.54.1")
        p.until(lambda: p.all('#live-fields [data-field$="joint_position"]'))
        p.run("document.querySelectorAll('#live-fields [data-field$=\"joint_position\"]').forEach(one => one.click())")
        p.run("""setInterval(() => {
            const angles = (document.querySelector('#live-arm-list g.reported')?.dataset.angles ?? '').split(' ').map(Number);
            if (angles[2] > 0.6 && angles[2] < 0.9 && document.querySelector('#live-arm-list g.commanded')) window.requestAnimationFrame = () => 0, document.body.dataset.stands = 'still';
        }, 5);""")
        p.until(lambda: p.run("return document.body.dataset.stands") == "still", "the arm was not seen on its way")
        p.run("document.querySelector('#live-messages').closest('section').hidden = true; document.querySelector('#live-arms').previousElementSibling.hidden = true;"
              "document.querySelector('#live-faults').closest('section').hidden = true;"
              "document.querySelectorAll('#live-buses .histogram').forEach(one => { one.parentElement.hidden = true; })")
        picture(p, "joints", "#live-shown", "#live-shown")
    finally:
        p.robot.end()
        p.robot = before


def main():
    p = page(whole_page, root / "build/web/pictures")
    p.pictures.mkdir(parents=True, exist_ok=True)
    p.robot = robot(programs, whole_page)
    wanted = sys.argv[2:] or ["message", "live", "joints"]
    try:
        for one in (message, live, joints):
            if one.__name__ in wanted:
                one(p)
    finally:
        p.robot.end()
        p.driver.quit()


if __name__ == "__main__":
    main()
