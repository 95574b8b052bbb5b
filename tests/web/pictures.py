#!/usr/bin/python3
"""pictures.py: makes build/web/pictures/message.png, live.png and joints.png, for scripts/web-pictures."""
import base64
import math
import subprocess
import sys

sys.dont_write_bytecode = True
from browser import page, root # noqa: E402
from live_test import choose, connected, points, robot, token, watch # noqa: E402

programs = root / "build/release/bin"
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
    """Efforts that change, for half a minute."""
    p.size(wide, 900)
    watch(p)
    p.robot.command(propulsive_linear_effort_x=0, propulsive_linear_effort_y=0)
    choose(p, "set_wrench_effort", "1.1.32.1")
    for field in ("propulsive_linear_effort_x", "propulsive_linear_effort_y"):
        p.find(f'#live-fields [data-field="{field}"]').click()
    p.robot.stop("ocu")
    for step in range(40):
        values = [f"propulsive_linear_effort_x={60 * math.sin(step / 6):.1f}", f"propulsive_linear_effort_y={40 * math.cos(step / 4):.1f}"]
        subprocess.run([programs / "ocu", "--config", p.robot.config, "--this", "a", *values], check=True, stdout=subprocess.DEVNULL)
    p.until(lambda: points(p, "propulsive_linear_effort_x") > 30)
    picture(p, "live", "#live-status", "#live-plot")


def joints(p):
    """The six joints of the examples as they move, seen by jausdump."""
    p.size(wide, 700)
    r = robot(programs, root / "build/web/jauscat.html")
    try:
        port = int(r.config.read_text().split("<name>b</name>")[1].split("<port>")[1].split("<")[0])
        own = []
        try:
            own.append(subprocess.Popen([programs / "emulated_drives"], stdout=subprocess.DEVNULL))
            arm = subprocess.Popen([programs / "six_joints", "--config", r.config, "--this", "b"], stdout=subprocess.PIPE, text=True)
            own.append(arm)
            while "slave 5 answers, in OP" not in arm.stdout.readline():
                assert arm.poll() is None, "six_joints has ended"
            own.append(subprocess.Popen([programs / "jausdump", "--listen", str(port), "--web", str(r.web_port), "--web-token", token,
                                         "--web-page", root / "build/web/jauscat.html"], stdout=subprocess.DEVNULL))
            p.driver.get("about:blank")
            p.driver.get(r.link())
            connected(p)
            # The picture stands still in the middle of the way.
            p.run("""setInterval(() => {
                const angles = (document.querySelector('#live-arm-list g.reported')?.dataset.angles ?? '').split(' ').map(Number);
                if (angles.length === 6 && angles[2] > 0.3 && angles[2] < 0.8 && document.querySelector('#live-arm-list g.commanded')) window.requestAnimationFrame = () => 0, document.body.dataset.stands = 'still';
            }, 5);""")
            subprocess.run([programs / "move_joints", "--config", r.config, "--this", "a"], check=True, stdout=subprocess.DEVNULL)
            p.until(lambda: p.run("return document.body.dataset.stands") == "still", "the arm was not seen on its way")
            picture(p, "joints", "#live-status", "#live-arm-list")
        finally:
            for one in reversed(own):
                one.terminate()
                one.wait(30)
    finally:
        r.end()


def main():
    p = page(root / "build/web/jauscat.html", root / "build/web/pictures")
    p.pictures.mkdir(parents=True, exist_ok=True)
    p.robot = robot(programs, root / "build/web/jauscat.html")
    wanted = sys.argv[1:] or ["message", "live", "joints"]
    try:
        for one in (message, live, joints):
            if one.__name__ in wanted:
                one(p)
    finally:
        p.robot.end()
        p.driver.quit()


if __name__ == "__main__":
    main()
