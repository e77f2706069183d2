// Certificates: the one of the arch that is shown, to be saved, and files to be checked.

/** As many bytes as the command reads. */
const MOST_BYTES = 64 * 2 ** 20;

at("save").addEventListener("click", async () => {
  const { given, found } = last;
  at("saved").textContent = "being proved in the second arithmetic …";
  const { certificate, reason } = await prove(given, found, { file: true });
  if (!certificate) return void (at("saved").textContent = `not proved here: ${reason}; the command below does`);
  const { sentence } = await checker.ask("check", [new TextEncoder().encode(certificate)]) ?? {};
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([certificate], { type: "application/json" }));
  link.download = "arch.json";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  at("saved").textContent = `arch.json: ${sentence}`;
});

at("copy").addEventListener("click", async () => {
  const code = at("certify-command");
  try {
    await navigator.clipboard.writeText(code.textContent);
    at("copied").textContent = "copied";
  } catch {
    getSelection().selectAllChildren(code);
    at("copied").textContent = "selected";
  }
  setTimeout(() => at("copied").textContent = "", 4000);
});

let files = [], isChecking = false;

/** A line of the list for a file, which can be given up while it waits or is checked. */
function line(file) {
  const item = document.createElement("li"), words = document.createElement("span"), cancel = document.createElement("button");
  words.textContent = `${file.name}: waits to be checked`;
  cancel.textContent = "Cancel";
  cancel.setAttribute("aria-label", `Cancel the check of ${file.name}`);
  item.append(words, " ", cancel);
  at("checked").prepend(item);
  const one = { file, words, isGivenUp: false, isChecked: false };
  cancel.addEventListener("click", () => {
    one.isGivenUp = true;
    if (one.isChecked) checker.stop();
    else tellLine(one, { accepted: false, sentence: "given up before it was checked" });
  });
  one.end = (isAccepted) => {
    cancel.remove();
    item.className = isAccepted ? "is-proved" : "is-refused";
  };
  return one;
}

function tellLine({ file, words, end }, { accepted, sentence }) {
  words.textContent = `${file.name}: ${sentence}`;
  end(accepted);
}

/** The verdict on a file. */
async function verdict(one) {
  if (one.file.size > MOST_BYTES) return { accepted: false, sentence: `refused: the file has more than ${MOST_BYTES} bytes` };
  try {
    const bytes = new Uint8Array(await one.file.arrayBuffer());
    return await checker.ask("check", [bytes]) ?? { accepted: false, sentence: "given up while it was checked" };
  } catch (error) {
    return { accepted: false, sentence: `not checked: ${error.message}` };
  }
}

/** Checks files one after the other. */
async function checkFiles(more) {
  files.push(...[...more].map(line));
  if (isChecking) return;
  isChecking = true;
  while (files.length) {
    const one = files.shift();
    if (one.isGivenUp) continue;
    one.isChecked = true;
    one.words.textContent = `${one.file.name}: checking …`;
    tellLine(one, await verdict(one));
  }
  isChecking = false;
}

at("files").addEventListener("change", ({ target }) => {
  checkFiles(target.files);
  target.value = "";
});
// A file that misses the field is not opened in place of the page.
addEventListener("dragover", (event) => { event.preventDefault(); at("drop").classList.add("is-over"); });
addEventListener("dragleave", () => at("drop").classList.remove("is-over"));
addEventListener("drop", (event) => {
  event.preventDefault();
  at("drop").classList.remove("is-over");
  checkFiles(event.dataTransfer.files);
});
