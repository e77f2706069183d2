// Proofs and checks run in workers, so that the page is never still: one for the arch that is shown, one for files.

/** The checker, unpacked and compiled once for all workers. */
let compiled = null;
async function unpacked() {
  const packed = Uint8Array.from(atob(at("wasm").textContent.trim()), (letter) => letter.charCodeAt(0));
  return WebAssembly.compile(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
}

/** A worker with the checker in WebAssembly, started when it is needed. */
class Engine {
  #worker = null;
  #waiting = new Map();
  #count = 0;
  #ready = null;

  /** Whether it can prove anything here; rejected with the reason if it cannot. */
  ready() {
    this.#ready ??= new Promise((resolve, reject) => {
      const address = URL.createObjectURL(new Blob([at("worker").textContent], { type: "text/javascript" }));
      const worker = new Worker(address);
      worker.addEventListener("error", () => reject(new Error("no worker can be started")));
      worker.addEventListener("message", ({ data: { ready, reason, id, answer } }) => {
        if (ready === undefined) {
          this.#waiting.get(id)?.(answer);
          this.#waiting.delete(id);
        } else if (ready) {
          resolve();
        } else {
          reject(new Error(reason));
        }
      });
      (compiled ??= unpacked()).then((module) => worker.postMessage({ module }), reject);
      this.#worker = worker;
      URL.revokeObjectURL(address);
    });
    return this.#ready;
  }

  /** The answer of a function to the first of some texts that it has one to, else its first reason; `null` if it is stopped. */
  async ask(name, inputs) {
    await this.ready();
    const id = this.#count++;
    return new Promise((resolve) => {
      this.#waiting.set(id, resolve);
      this.#worker.postMessage({ id, name, inputs });
    });
  }

  /** Ends what it does. */
  stop() {
    this.#worker?.terminate();
    this.#worker = this.#ready = null;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    waiting.forEach((resolve) => resolve(null));
  }
}

const prover = new Engine(), checker = new Engine();
const encoded = (value) => new TextEncoder().encode(JSON.stringify(value));
