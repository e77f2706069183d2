"use strict";
// What runs beside the page: the checker in WebAssembly. It is asked by { id, name, texts } and answers the last of what
// came of the texts, the first of which has no reason why it is not proved.

let bytes = null, engine = null;

async function load() {
  engine = (await WebAssembly.instantiate(bytes)).instance.exports;
}

/** What a function of the engine makes of a text; one that stops, as for want of memory, is loaded anew. */
async function call(name, input) {
  if (!engine) await load();
  try {
    const place = engine.input(input.length);
    new Uint8Array(engine.memory.buffer, place, input.length).set(input);
    const length = engine[name]();
    return JSON.parse(new TextDecoder().decode(new Uint8Array(engine.memory.buffer, engine.output(), length)));
  } catch (error) {
    engine = null;
    return { accepted: false, sentence: `not checked: the checker stopped (${error.message})`, reason: `the checker stopped (${error.message})` };
  }
}

addEventListener("message", async ({ data: { wasm, id, name, inputs } }) => {
  if (wasm !== undefined) {
    try {
      const packed = Uint8Array.from(atob(wasm.trim()), (letter) => letter.charCodeAt(0));
      bytes = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
      await load();
      postMessage({ ready: true });
    } catch (error) {
      postMessage({ ready: false, reason: error.message });
    }
    return;
  }
  let first = null;
  for (const input of inputs) {
    const answer = await call(name, input);
    if (answer.reason === undefined) return void postMessage({ id, answer });
    first ??= answer;
  }
  postMessage({ id, answer: first });
});
