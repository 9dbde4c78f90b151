import { Engine } from './engine.js'; // installed: from 'gaitsmith-engine'

const engine = await Engine.load();
const figure = { name: 'Worm', rods: [{ rest_rad: 0.6 }, { parent: 0, rest_rad: -1.2 }, { parent: 1, rest_rad: 1.2 }] };
const document = engine.documentFromText(JSON.stringify({ figure, search: { evaluations: 6000 } }));
const search = engine.search(document);
const evaluator = engine.evaluator(document);
while (!search.done) search.tell(evaluator.evaluate(search.ask(40)));
console.log(`moved ${search.bestFitness.toFixed(2)} m`);
globalThis.document?.body.append(`moved ${search.bestFitness.toFixed(2)} m`);
