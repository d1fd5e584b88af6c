"""test_view.py FOLDER CLAIM: one claim about the pages of FOLDER (prepare_runs.sh), in a real browser. Ends with 77
where there is none. FOLDER CLAIM `speed` asserts nothing and prints frames a second."""

import base64
import contextlib
import json
import math
import pathlib
import subprocess
import sys

import chromium
from picture import distance
from recorded_run import RecordedRun
from replay_page import IS_FINGER, ReplayPage, is_background, is_object

SKIPPED = 77

# Rotations and forces come to the page in whole ten-thousandths and thousandths.
ROUNDED = 1e-4


def check(true, what):
    if not true:
        raise chromium.Failure(what)


@contextlib.contextmanager
def replay(**options):
    """An empty browser that is to have had no complaint, and to have asked for nothing, when it is closed."""
    with chromium.page(**options) as browser:
        yield ReplayPage(browser)
        check(not browser.complaints(), f"the console says {browser.complaints()}")
        check(not browser.requests(), f"it asked for {browser.requests()}")
        loaded = browser.value("performance.getEntriesByType('resource').map(e => e.name)")
        check(not [name for name in loaded if not name.startswith("data:")], f"it loaded {loaded}")


def plays_and_pauses(folder):
    with replay() as page:
        page.open_at(folder / "run/replay.html", 20)
        check(not page.playing() and page.step() == 20, "does not begin still, at the step of its address")
        page.click("play")
        page.browser.wait_for("twiddle.isPlaying() && twiddle.step() > 25")
        page.click("play")
        stopped = page.step()
        check(not page.playing(), "a click does not stop it")
        page.browser.value("new Promise(done => setTimeout(done, 200))")
        check(page.step() == stopped, "goes on after it was stopped")
        page.browser.value("document.activeElement.blur()")
        for playing in (True, False):
            page.browser.press(" ")
            check(page.playing() == playing, "Space neither plays nor stops")


def plays_by_itself_and_begins_again(folder):
    with replay() as page:
        page.browser.open(folder / "run/replay.html")
        page.browser.wait_for("twiddle.isPlaying() && twiddle.step() > 5")
        page.browser.value("twiddle.setStep(298)")
        page.browser.value("twiddle.play()")
        page.browser.wait_for("twiddle.step() < 250")


def speed_is_what_was_chosen(folder):
    with replay() as page:
        page.open_at(folder / "run/replay.html", 1)
        steps = {}
        for speed in ("0.1", "2"):
            page.browser.value(f"document.getElementById('speed').value = '{speed}'")
            page.browser.value("twiddle.setStep(1); twiddle.play()")
            page.browser.value("new Promise(done => setTimeout(done, 900))")
            page.browser.value("twiddle.pause()")
            steps[speed] = page.step()
        check(steps["2"] > 3 * steps["0.1"], f"went {steps} steps")


def steps_by_keys_slider_and_address(folder):
    with replay() as page:
        page.open_at(folder / "run/replay.html", 150)
        check(page.step() == 150 and page.text("step") == "150", "the address says step 150")
        for key, expected in (("ArrowRight", 151), ("ArrowRight", 152), ("ArrowLeft", 151)):
            page.browser.press(key)
            check(page.step() == expected and page.text("step") == str(expected), f"{key} does not lead to {expected}")
        page.scrub_to(77)
        check(page.step() == 77 and page.text("step") == "77", "the slider does not lead to 77")
        check(page.browser.value("location.hash") == "#step=77", "the address does not follow the slider")
        page.browser.value("location.hash = '#step=210'")
        page.browser.wait_for("twiddle.step() === 210")
        for wrong, expected in (("-5", 1), ("1e9", 300), ("NaN", 1)):
            page.browser.value(f"twiddle.setStep({wrong})")
            check(page.step() == expected, f"step {wrong} is {page.step()}")


def says_the_numbers_of_the_csv(folder):
    run = RecordedRun(folder / "run")
    with replay() as page:
        page.open_at(folder / "run/replay.html", 1)
        for step in (1, 2, 50, 111, 150, 233, 299, 300):
            page.scrub_to(step)
            row = run.row(step)
            for name, column in (("step", "step"), ("time", "time_s"), ("rotation", "object_rad"),
                                 ("index-force", "index_contact_n"), ("thumb-force", "thumb_contact_n")):
                said, half_unit = page.number(name)
                check(abs(said - row[column]) <= half_unit + ROUNDED, f"step {step}: {name} {said}, not {row[column]}")


def silhouette(page, run):
    """The projected centre and radius of a spherical object, px."""
    centre = page.project(run.object_m())
    return centre, max(math.dist(page.project(point), centre) for point in run.sphere_m())


def object_is_where_its_projection_is(folder):
    run = RecordedRun(folder / "run")
    with replay() as page:
        page.open_at(folder / "run/replay.html", 1)
        centre, radius = silhouette(page, run)
        picture = page.picture()
        green = [(x, y) for y in range(picture.height) for x in range(picture.width)
                 if is_object(picture.pixel(x, y))]
        inside = [point for point in green if math.dist(point, centre) <= radius + 2]
        check(len(inside) == len(green), f"{len(green) - len(inside)} px of the object are outside its projection")
        check(len(green) > 0.15 * math.pi * radius**2, f"{len(green)} px of the object in a radius of {radius:.0f} px")
        reach = max(math.dist(point, centre) for point in green)
        check(reach > radius - 4, f"the object reaches {reach:.1f} px, its projection {radius:.1f} px")


def box_around(picture, centre, half):
    x, y = (round(value) for value in centre)
    return [picture.pixel(column, row) for row in range(max(0, y - half), min(picture.height, y + half + 1))
            for column in range(max(0, x - half), min(picture.width, x + half + 1))]


def share(pixels, is_kind):
    return sum(map(is_kind, pixels)) / len(pixels)


def turn_a_quarter(page):
    x, y, width, height = page.box("scene")
    page.browser.drag((x + width / 4, y + height / 2), (x + width / 4 + 157, y + height / 2))


def fingertips_are_where_their_projections_are(folder):
    run = RecordedRun(folder / "run")
    with replay() as page:
        page.open_at(folder / "run/replay.html", 1)
        # Where nothing touches, no glow lies over a tip; from one of four sides the object does not hide it.
        visible = {}
        for _ in range(4):
            for finger, is_finger in IS_FINGER.items():
                free = [int(row["step"]) for row in run.rows if row[f"{finger}_contact_n"] == 0]
                for step in free[::max(1, len(free) // 6)]:
                    page.scrub_to(step)
                    box = page.pixels_around(page.project(run.tip_m(step, finger)), 2)
                    check(share(box, is_background) == 0, f"step {step}: nothing is drawn at the {finger}'s tip")
                    visible[finger, step] = visible.get((finger, step), False) or share(box, is_finger) > 0.8
            turn_a_quarter(page)
        hidden = [place for place, seen in visible.items() if not seen]
        check(len(visible) >= 12 and not hidden, f"not seen from any side: {hidden}")


def far_apart(run, finger):
    """Two steps between which the fingertip moves most."""
    tips = [run.tip_m(step, finger) for step in range(1, len(run.rows) + 1)]
    first = max(range(len(tips)), key=lambda i: math.dist(tips[0], tips[i]))
    second = max(range(len(tips)), key=lambda i: math.dist(tips[first], tips[i]))
    return first + 1, second + 1


def fingertip_moves_and_the_background_stays(folder):
    run = RecordedRun(folder / "run")
    with replay() as page:
        page.open_at(folder / "run/replay.html", 1)
        for finger in IS_FINGER:
            pictures, steps = [], far_apart(run, finger)
            for step in steps:
                page.scrub_to(step)
                pictures.append(page.picture())
            tip = page.project(run.tip_m(steps[0], finger))
            boxes = [box_around(picture, tip, 5) for picture in pictures]
            changed = sum(distance(a, b) > 30 for a, b in zip(*boxes))
            check(changed > 12, f"{changed} px of the {finger}'s box differ between steps {steps}")
            corners = [box_around(picture, (12, 12), 8) for picture in pictures]
            check(corners[0] == corners[1], "a corner of the picture changes")
            check(share(corners[0], is_background) == 1, f"the corner is {corners[0][0]}")


def turns_and_zooms(folder):
    run = RecordedRun(folder / "run")
    with replay() as page:
        page.open_at(folder / "run/replay.html", 100)
        _, radius = silhouette(page, run)
        tip, before = page.project(run.tip_m(100, "index")), page.picture().pixels()
        x, y, width, height = page.box("scene")
        middle = (x + width / 2, y + height / 2)
        page.browser.drag(middle, (middle[0] + 60, middle[1] + 10))
        check(math.dist(page.project(run.tip_m(100, "index")), tip) > 10, "dragging turns nothing")
        check(page.picture().pixels() != before, "dragging draws nothing anew")
        page.browser.turn_wheel(*middle, -300)
        check(silhouette(page, run)[1] > 1.1 * radius, "the wheel does not zoom in")
        check(page.step() == 100, "turning changes the step")


def two_runs_stand_side_by_side(folder):
    runs = {"": RecordedRun(folder / "run"), "-2": RecordedRun(folder / "other")}
    with replay(width=1200, height=700) as page:
        page.open_at(folder / "both.html", 180)
        check(page.browser.value("document.querySelectorAll('figure canvas').length") == 2, "not two pictures")
        first, second = page.box("scene"), page.box("scene-2")
        check(first[0] + first[2] <= second[0] and abs(first[1] - second[1]) < 2, "they do not stand side by side")
        for end, run in runs.items():
            said, half_unit = page.number("rotation" + end)
            check(abs(said - run.row(180)["object_rad"]) <= half_unit + ROUNDED, f"rotation{end} is {said}")
        for canvas in ("scene", "scene-2"):
            pixels = page.picture(canvas).pixels()
            check(share(pixels, is_object) > 0.01, f"{canvas} shows no object")
            check(share(pixels, is_background) > 0.2, f"{canvas} has no background")


def index_opens_every_run(folder):
    listed = json.loads((folder / "sweep/sweep.json").read_text(encoding="utf-8"))["runs"]
    with replay() as page:
        links = open_index(page, folder)
        check(len(links) == len(listed) == 8, f"{len(links)} links for {len(listed)} runs")
        opened = set()
        for place, (_, said) in enumerate(links):
            open_index(page, folder)
            page.browser.value(f"document.querySelectorAll('td a')[{place}].click()")
            page.browser.wait_for("window.twiddle !== undefined")
            page.browser.value("twiddle.setStep(300)")
            rotation, half_unit = page.number("rotation")
            check(abs(rotation - float(said.replace("\u2212", "-"))) <= 0.005 + half_unit + ROUNDED,
                  f"a link says {said}, its page {rotation}")
            opened.add(page.browser.value("location.pathname"))
        check(len(opened) == len(listed), f"{len(listed)} links open {len(opened)} pages")


def open_index(page, folder):
    page.browser.open(folder / "sweep/index.html")
    return page.browser.value("[...document.querySelectorAll('td a')].map(a => [a.href, a.textContent.trim()])")


def text_of_a_run_stays_text(folder):
    with replay() as page:
        page.open_at(folder / "harmful/replay.html", 40)
        check(page.browser.value("typeof window.harmed") == "undefined", "text of the run was run")
        check(page.browser.value("document.querySelectorAll('script').length") == 2, "there is a script more")
        check(page.browser.value("document.querySelectorAll('img').length") == 0, "there is an image")
        check("</script><script>window.harmed = 1</script>" in page.text("facts"), "the text is not shown as it is")
        check(page.step() == 40, "the page does not work")


def says_so_without_webgl(folder):
    run = RecordedRun(folder / "run")
    with replay(flags=["--disable-3d-apis"]) as page:
        page.open_at(folder / "run/replay.html", 300)
        check(page.box("no-webgl")[3] > 0 and "WebGL" in page.text("no-webgl"), "there is no sentence")
        said, half_unit = page.number("rotation")
        check(abs(said - run.row(300)["object_rad"]) <= half_unit + ROUNDED, f"the rotation is {said}")


def film_has_a_frame_every_fifth_step(folder):
    film = folder / "film.webp"
    plots = pathlib.Path(chromium.__file__).parent
    subprocess.run([plots / "film-run", folder / "run", film], check=True)
    with replay() as page:
        page.browser.open(folder / "sweep/index.html")
        # The browser's own decoder, which had no part in putting the frames together.
        frames = page.browser.value(f"""(async () => {{
            const data = Uint8Array.from(atob('{base64.b64encode(film.read_bytes()).decode()}'), c => c.charCodeAt(0));
            const decoder = new ImageDecoder({{data, type: 'image/webp'}});
            await decoder.tracks.ready;
            await decoder.completed;
            const frames = [];
            for (let i = 0; i < decoder.tracks.selectedTrack.frameCount; i++) {{
                const {{image}} = await decoder.decode({{frameIndex: i}});
                frames.push([image.displayWidth, image.displayHeight, image.duration / 1000]);
            }}
            return frames;
        }})()""")
        check(len(frames) == 60, f"{len(frames)} frames of 300 steps")
        check(all(frame[:2] == frames[0][:2] and frame[2] == 50 for frame in frames[:-1]), f"the frames are {frames}")


def speed(folder):
    """Frames a second of a picture of 800 x 600, printed."""
    with replay(width=1400, height=1100) as page:
        page.open_at(folder / "run/replay.html", 1)
        page.browser.value("document.getElementById('scene').style.cssText = 'width: 800px; height: 600px'")
        page.browser.value("dispatchEvent(new Event('resize')); twiddle.play()")
        frames = page.browser.value("""new Promise(done => {
            const begin = performance.now();
            let frames = 0;
            const count = now => now - begin < 3000 ? (frames++, requestAnimationFrame(count)) : done(frames / 3);
            requestAnimationFrame(count);
        })""")
        print(f"{frames:.1f} frames a second at {page.box('scene')[2]:.0f} x {page.box('scene')[3]:.0f}")


def main():
    folder, claim = pathlib.Path(sys.argv[1]), sys.argv[2]
    if chromium.installed() is None:
        print("skipped: there is no chromium; scripts/install-deps test installs it")
        return SKIPPED
    try:
        globals()[claim](folder)
    except chromium.Failure as failure:
        print(f"FAILED {claim}: {failure}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
