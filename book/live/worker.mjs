// In the page's worker: one question after another to the engine. A message is { packs, chapter } once, then
// { id, ask: [method, ...arguments] }; the answer is { id, answer } or { id, fault }.
import { Engine } from './engine.mjs';

let engine;
onmessage = async ({ data: { packs, chapter, id, ask } }) => {
  if (packs) {
    engine = new Engine(packs, chapter);
    return;
  }
  const [method, ...given] = ask;
  try {
    postMessage({ id, answer: await engine[method](...given) });
  } catch (fault) {
    postMessage({ id, fault: fault.message ?? String(fault) });
  }
};
