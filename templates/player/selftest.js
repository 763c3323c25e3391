// play.html#selftest goes through everything (#selftest=8: every eighth place of the drive) and writes what it found into data-selftest of the root element.
if (wish.has("selftest")) requestAnimationFrame(() => setTimeout(() => {
  const found = { steps: [], places: [], errors: [] };
  addEventListener("error", (event) => found.errors.push(event.message));
  const shows = (node) => getComputedStyle(node).display !== "none";
  for (const lang of ["zh", "en"]) {
    player.setLang(lang);
    for (let step = 1; step <= cut.length; step++) {
      player.go(step);
      const groups = figures.flatMap((figure) => figure.groups);
      found.steps.push({
        lang, step, slider: +slider.value, said: live.textContent.length, text: steps[player.step - 1].innerText.length, whole: player.step,
        shown: groups.filter(({ group }) => shows(group)).every((g) => g.step <= step) && groups.filter((g) => g.step <= step).every(({ group }) => shows(group)),
        now: groups.filter((g) => g.step === step).length, marked: all("#drawn .now").length, current: all("#steps li.cur").length,
      });
    }
  }
  if (one("#motion")) {
    one("#mode-turn").click();
    for (let place = 0; place < turn.data.shown.length; place += +wish.get("selftest") || 1) {
      player.go(place);
      found.places.push({ angle: one("#degrees").textContent, paths: all("#turned path").length, readings: all("#turn td").filter((cell) => cell.textContent).length });
    }
    one("#mode-steps").click();
  }
  document.dispatchEvent(new KeyboardEvent("keydown", { key: "Home" }));
  const keys = [player.beat];
  for (const key of ["ArrowRight", "ArrowRight", "ArrowLeft", "End", "Home"]) { document.dispatchEvent(new KeyboardEvent("keydown", { key })); keys.push(player.beat); }
  found.keys = keys;
  const width = stage.camera.w;
  one("#zoom-in").click();
  found.zoomed = stage.camera.w < width;
  found.unnamed = all("button, input").filter((node) => !(node.getAttribute("aria-label") || node.innerText.trim())).length;
  found.loads = performance.getEntriesByType("resource").length;
  const paint = performance.getEntriesByName("first-contentful-paint")[0];
  found.paint = paint ? paint.startTime : null;
  root.dataset.selftest = JSON.stringify(found);
}, 50));
