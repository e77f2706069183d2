// The picture of the arch, which the program's own drawing made, and its motion.

/** There and back, as the picture has it: it begins where the blocks have fallen. */
const SECONDS = 5;
let isPlaying = !matchMedia("(prefers-reduced-motion: reduce)").matches;

const picture = () => at("arch").querySelector("svg");

/** A picture in place of the last, at the same moment of its motion. */
function draws(svg, words) {
  const time = picture()?.querySelector("animateTransform") ? picture().getCurrentTime() : 0;
  // Names in it begin with that of the picture, so that no two on the page are the same.
  at("arch").innerHTML = svg.replace(/id="/g, 'id="arch-');
  const drawn = picture(), title = drawn.querySelector("title");
  title?.remove();
  drawn.setAttribute("aria-label", words);
  drawn.setCurrentTime(time);
  if (isPlaying) drawn.unpauseAnimations(); else drawn.pauseAnimations();
}

/** How far the blocks have fallen, in parts of the motion. */
const fallen = (time) => (1 + Math.cos(2 * Math.PI * time / SECONDS)) / 2;

function follow() {
  if (!isPlaying || at("moving").hidden || !picture()) return;
  at("motion").value = Math.round(100 * fallen(picture().getCurrentTime()));
}
setInterval(follow, 100);

function play(isOn) {
  isPlaying = isOn;
  at("play").textContent = isOn ? "Pause" : "Play";
  if (isOn) picture()?.unpauseAnimations(); else picture()?.pauseAnimations();
}

at("play").addEventListener("click", () => play(!isPlaying));
at("motion").addEventListener("input", ({ target }) => {
  play(false);
  picture()?.setCurrentTime(SECONDS / (2 * Math.PI) * Math.acos(2 * target.value / 100 - 1));
});
play(isPlaying);
