// SPDX-License-Identifier: MIT
// The eight questions that a class answers before the lessons and again after them (docs/does-it-teach.md). They ask for
// ideas in other surroundings than the playground, so that a class without the lessons can answer them, too. The wrong
// answers are what people often believe. Pages show them in their language (tr).
import { trLater } from '../languages/language.js';

/** lesson: its number; right: the number of the right answer, from 0 @typedef {{lesson: number, question: string, answers: string[], right: number, why: string}} Asked */

/** Changes with every change of a question or of an answer's place, because results of two sets cannot be compared. */
export const SET = '1';

/** @type {Asked[]} */
export const QUESTIONS = [
  {
    lesson: 1, right: 2,
    question: trLater('A cleaning robot has two rules: drive straight ahead, and turn away when you bump into something. After an hour the floor is clean. Where is the plan of its path?'),
    answers: [trLater('In the robot: it remembers where it has been.'), trLater('In the program: it lists the turns one by one.'), trLater('Nowhere: the two rules and the walls together make the path.'), trLater('In the first rule: it knows the room.')],
    why: trLater('The rules know no room. What the robot does comes from its rules and its surroundings together.'),
  },
  {
    lesson: 2, right: 1,
    question: trLater('In thick fog you look for the highest point of a landscape. You always take a small step uphill, and stop where every step would lead down. Where do you stop?'),
    answers: [trLater('At the highest point, if you take enough steps.'), trLater('On top of some hill, which may be a low one.'), trLater('At the highest point, because you only went up.'), trLater('Somewhere on a slope.')],
    why: trLater('Small steps uphill end on the hill on which they began. More steps do not help. Another start may.'),
  },
  {
    lesson: 3, right: 3,
    question: trLater('A garden sprinkler is switched on by a clock at six every morning. It has rained all night. What does the sprinkler do at six?'),
    answers: [trLater('It stays off, because the ground is wet.'), trLater('It waters less than usual.'), trLater('It waters this time, and learns from it for the next rain.'), trLater('It waters as on every other day.')],
    why: trLater('A clock feels nothing. Without a sense for water, rain cannot change what the sprinkler does.'),
  },
  {
    lesson: 3, right: 0,
    question: trLater('A program has learnt from thousands of pictures in sunshine to tell ripe tomatoes from unripe ones. At night it makes many mistakes. What is the most likely reason?'),
    answers: [trLater('It has learnt from nothing that looks like this.'), trLater('It has forgotten what it learnt.'), trLater('Its computer is too slow for pictures at night.'), trLater('Nobody has told it that it is night.')],
    why: trLater('What was never met in learning was never learnt. A message that it is night would not show it tomatoes in the dark.'),
  },
  {
    lesson: 4, right: 2,
    question: trLater('A company begins to pay its programmers for every error that they correct. What should it expect?'),
    answers: [trLater('Its programs have fewer errors.'), trLater('Nothing changes, because everybody already does their best.'), trLater('More errors are corrected, and more are made.'), trLater('The programmers work more slowly, because they are paid more.')],
    why: trLater('What is rewarded is done more. Correcting is rewarded here, not programs without errors.'),
  },
  {
    lesson: 5, right: 3,
    question: trLater('Two recipes are compared. Each cake is baked once: cake A gets 8 points, cake B gets 7. What do we know?'),
    answers: [trLater('Recipe A is better.'), trLater('Recipe A is better, if the judges were fair.'), trLater('Both recipes are equally good.'), trLater('Not much: baked again, B may win.')],
    why: trLater('One cake may turn out well or badly by chance. Only several of each show how much chance there is.'),
  },
  {
    lesson: 7, right: 1,
    question: trLater('A film of a runner is cut, and goes on with a film of another runner. A real person shall be able to run it like this. What must fit where the films meet?'),
    answers: [trLater('The place where the runner is.'), trLater('The pose, and how fast each part of the body moves.'), trLater('Only the pose.'), trLater('Only the direction.')],
    why: trLater('Two runners in the same pose may move at different speeds. A body cannot jump from one speed to another.'),
  },
  {
    lesson: 8, right: 0,
    question: trLater('Dogs with very short legs were bred from dogs with longer legs. What made the legs short?'),
    answers: [trLater('Chance made differences, and people chose which dogs had puppies.'), trLater('The dogs used their legs less and less.'), trLater('The breeders changed the legs step by step.'), trLater('Chance alone, over a long time.')],
    why: trLater('Chance makes differences, and a choice decides which of them go on. Neither does it alone.'),
  },
];

export const UNKNOWN = trLater('I do not know');
