# SPDX-License-Identifier: MIT
"""Environments keep the published rules of Gymnasium 1.0 and later, and have the physics of motions."""
import unittest
import warnings

import numpy as np

import gaitsmith
from gaitsmith.spaces import OwnBox

try:
    import gymnasium
except ImportError:
    gymnasium = None


def short(model: int = 1, **changes) -> dict:
    """Mr. Star-Man for 0.2 s."""
    document = gaitsmith.document(problem="star-man-travel", duration=0.2, joints="limited" if model == 2 else "strong")
    document.update(changes)
    return document


def vector(*arguments, **options) -> gaitsmith.VectorEnv:
    """An environment that draws the same actions each time."""
    env = gaitsmith.VectorEnv(*arguments, **options)
    env.action_space.seed(1)
    return env


def breaking() -> dict:
    """A motion whose physics breaks within its first steps: a heavy push."""
    document = short()
    document["pushes"] = [{"step": 3, "endpoint": 0, "impulse_x_ns": 1e6, "impulse_y_ns": 0}]
    return document


class Rules(unittest.TestCase):
    def check_step(self, env, step):
        observations, rewards, terminated, truncated, infos = step
        self.assertTrue(env.observation_space.contains(observations))
        for array, kind in ((rewards, np.float64), (terminated, np.bool_), (truncated, np.bool_)):
            self.assertEqual(array.shape, (env.num_envs,))
            self.assertEqual(array.dtype, kind)
        self.assertFalse(np.any(terminated & truncated))
        for name in infos:
            self.assertIn(name if name.startswith("_") else f"_{name}", infos)

    def test_spaces_and_five_values(self):
        for model in (1, 2):
            for observation in ("senses", "state"):
                env = vector(short(model), 3, observation)
                n, joints = len(env.observation_names), 4
                self.assertEqual(env.single_observation_space.shape, (n,))
                self.assertEqual(env.observation_space.shape, (3, n))
                self.assertEqual(env.action_space.shape, (3, joints))
                self.assertEqual(env.single_action_space.dtype, np.float32)
                self.assertIs(env.metadata["autoreset_mode"], type(env.metadata["autoreset_mode"]).NEXT_STEP)
                observations, infos = env.reset(seed=1)
                self.assertTrue(env.observation_space.contains(observations))
                self.assertEqual(infos["travel"].tolist(), [0.0] * 3)
                for _ in range(25):
                    self.check_step(env, env.step(env.action_space.sample()))

    def test_action_space_is_the_limits(self):
        document = short()
        limits = [(rod["min_rad"], rod["max_rad"]) for rod in document["figure"]["rods"] if rod["parent"] != -1]
        env = vector(document)
        self.assertEqual(
            sorted(zip(env.single_action_space.low.tolist(), env.single_action_space.high.tolist())),
            sorted((float(np.float32(low)), float(np.float32(high))) for low, high in limits),
        )
        other = vector(document)
        env.reset(), other.reset()
        for _ in range(5):  # targets beyond the limits are brought into them
            far, limit = env.step(np.full((1, 4), 9.0)), other.step(other.action_space.high)
            np.testing.assert_array_equal(far[0], limit[0])

    def test_next_step_autoreset(self):
        env = vector(short(), 2, "state")
        first, _ = env.reset(seed=0)
        for step in range(1, 21):
            seen, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
            self.assertEqual(truncated.tolist(), [step == 20] * 2)
        self.assertFalse(np.array_equal(seen, first))
        self.assertNotIn("final_obs", infos)
        # The action is ignored, even if it is no action.
        seen, rewards, terminated, truncated, infos = env.step(np.full((2, 4), np.nan))
        np.testing.assert_array_equal(seen, first)
        self.assertEqual(rewards.tolist(), [0.0, 0.0])
        self.assertFalse(terminated.any() or truncated.any())
        self.assertEqual(infos["travel"].tolist(), [0.0, 0.0])
        for step in range(1, 21):  # the whole duration again
            truncated = env.step(env.action_space.sample())[3]
            self.assertEqual(truncated.tolist(), [step == 20] * 2)

    def test_same_step_autoreset(self):
        env, other = (vector(short(), 2, "state", mode) for mode in ("same_step", "next_step"))
        first, _ = env.reset()
        other.reset()
        env.action_space.seed(5)
        for _ in range(20):
            action = env.action_space.sample()
            seen, rewards, terminated, truncated, infos = env.step(action)
            last = other.step(action)
        np.testing.assert_array_equal(seen, first)
        np.testing.assert_array_equal(np.stack(infos["final_obs"]), last[0])
        np.testing.assert_array_equal(rewards, last[1])
        np.testing.assert_array_equal(infos["final_info"]["travel"], last[4]["travel"])
        self.assertEqual(infos["_final_obs"].tolist(), [True, True])
        self.assertEqual(infos["_final_info"].tolist(), [True, True])
        self.assertEqual(infos["travel"].tolist(), [0.0, 0.0])
        self.assertNotIn("final_obs", env.step(action)[4])

    def test_without_autoreset(self):
        env = vector(short(), 3, autoreset_mode="disabled")
        env.reset()
        for _ in range(10):
            env.step(env.action_space.sample())
        env.reset(options={"reset_mask": np.array([False, True, False])})
        for _ in range(10):
            truncated = env.step(env.action_space.sample())[3]
        self.assertEqual(truncated.tolist(), [True, False, True])
        with self.assertRaisesRegex(gaitsmith.Error, "world 0 has ended"):
            env.step(env.action_space.sample())
        env.reset(options={"reset_mask": truncated})
        self.assertFalse(env.step(env.action_space.sample())[3].any())

    def test_broken_physics_terminates(self):
        for mode in ("next_step", "same_step"):
            env = vector(breaking(), 2, "state", mode)
            env.reset()
            total = np.zeros(2)
            for _ in range(20):
                step = env.step(np.tile(env.action_space.sample()[0], (2, 1)))
                self.check_step(env, step)
                total += step[1]
                if step[2].any():
                    break
            self.assertTrue(step[2].all())
            self.assertFalse(step[3].any())
            np.testing.assert_allclose(total, 0.0, atol=1e-12)

    def test_seeds_repeat_starts_of_each_world(self):
        def starts(envs, seed, mode="next_step"):
            env = vector(short(), envs, "state", mode, start_noise=0.5)
            seen = [env.reset(seed=seed)[0]]
            for _ in range(22):
                seen.append(env.step(np.zeros((envs, 4)))[0])
            return np.array(seen)

        np.testing.assert_array_equal(starts(3, 7), starts(3, 7))
        np.testing.assert_array_equal(starts(3, 7)[:, :2], starts(2, 7))
        self.assertFalse(np.array_equal(starts(3, 7), starts(3, 8)))
        self.assertFalse(np.array_equal(starts(3, 7)[0], starts(3, 7)[21]))  # the next episode begins otherwise

    def test_arrays_stay_as_they_were_returned(self):
        env = vector(short(), 2)
        kept = [env.reset()[0]]
        kept += list(env.step(env.action_space.sample()))[:4]
        copies = [array.copy() for array in kept]
        env.step(env.action_space.sample())
        for array, copy in zip(kept, copies):
            np.testing.assert_array_equal(array, copy)

    def test_wrong_arguments_are_named(self):
        env = vector(short(), 2)
        with self.assertRaisesRegex(gaitsmith.Error, "reset must come first"):
            env.step(env.action_space.sample())
        with self.assertRaisesRegex(gaitsmith.Error, "first reset must be of all"):
            env.reset(options={"reset_mask": np.array([True, False])})
        env.reset()
        nan = np.zeros((2, 4))
        nan[1, 2] = np.nan
        handover = gaitsmith.document(problem="star-man-shuffle", handover=["star-man-shuffle@1"])
        for call, words in [
            (lambda: env.step(np.zeros((2, 3))), r"actions: must be numbers with shape \(2, 4\), has shape \(2, 3\)"),
            (lambda: env.step(np.zeros(4)), "has shape"),
            (lambda: env.step("up"), "actions"),
            (lambda: env.step(None), "actions"),
            (lambda: env.step(nan), r"actions\[1, 2\]: must be finite"),
            (lambda: env.reset(seed=-1), "seed"),
            (lambda: env.reset(seed="a"), "seed"),
            (lambda: env.reset(options={"reset_mask": [1, 0]}), "reset_mask"),
            (lambda: vector(short(), 0), "num_envs: must be from 1"),
            (lambda: vector(short(), observation="all"), "observation: must be one of senses, state"),
            (lambda: vector(short(), autoreset_mode="never"), "autoreset_mode"),
            (lambda: vector(short(), tau=0), "tau: must be from 0.02"),
            (lambda: vector(short(), tau=float("nan")), "tau"),
            (lambda: vector(short(), tau="fast"), "tau"),
            (lambda: vector(short(), frame_skip=0), "frame_skip"),
            (lambda: vector(short(), start_noise=-1), "start_noise"),
            (lambda: vector(handover), "begins at the start"),
            (lambda: vector(gaitsmith.document(problem="star-man-travel", search_option={"worlds": 2})), "one world"),
        ]:
            with self.subTest(words), self.assertRaisesRegex(gaitsmith.Error, words):
                call()
        env.close()
        with self.assertRaisesRegex(gaitsmith.Error, "is closed"):
            env.reset()

    def test_one_world(self):
        env, other = gaitsmith.Env(short(), "state"), vector(short(), 1, "state")
        one, many = env.reset(seed=1), other.reset(seed=1)
        np.testing.assert_array_equal(one[0], many[0][0])
        for _ in range(20):
            action = env.action_space.sample()
            one, many = env.step(action), other.step(action[np.newaxis])
            np.testing.assert_array_equal(one[0], many[0][0])
            self.assertEqual((type(one[1]), type(one[2]), type(one[3])), (float, bool, bool))
            self.assertEqual(one[1:4], (many[1][0], many[2][0], many[3][0]))
        self.assertTrue(one[3])
        env.close()

    @unittest.skipIf(gymnasium is None, "Gymnasium is not installed")
    def test_gymnasiums_own_checker(self):
        from gymnasium.utils.env_checker import check_env

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            check_env(gaitsmith.Env(short(), "state"), skip_render_check=True)
        self.assertIsInstance(gaitsmith.VectorEnv(short()), gymnasium.vector.VectorEnv)

    @unittest.skipIf(gymnasium is None, "Gymnasium is not installed")
    def test_same_as_gymnasiums_vector_of_single_worlds(self):
        from gymnasium.vector import AutoresetMode, SyncVectorEnv

        for mode in (AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP):
            ours = vector(short(), 2, "state", mode)
            theirs = SyncVectorEnv([lambda: gaitsmith.Env(short(), "state")] * 2, autoreset_mode=mode)
            self.assertEqual(ours.observation_space, theirs.observation_space)
            self.assertEqual(ours.action_space, theirs.action_space)
            self.assertEqual(ours.metadata["autoreset_mode"], theirs.metadata["autoreset_mode"])
            pairs = [(ours.reset(seed=1), theirs.reset(seed=1))]
            for _ in range(45):
                action = ours.action_space.sample()
                pairs.append((ours.step(action), theirs.step(action)))
            for one, other in pairs:
                self.check_same(one, other)

    def check_same(self, one, other):
        if isinstance(one, dict):
            self.assertEqual(set(one), set(other))
            one, other = ([values[name] for name in sorted(values)] for values in (one, other))
        if isinstance(one, (tuple, list)):
            for ours, theirs in zip(one, other):
                self.check_same(ours, theirs)
        else:
            self.assertEqual(one.dtype, other.dtype)
            if one.dtype == object:
                one, other = np.stack(one), np.stack(other)
            np.testing.assert_array_equal(one, other)


class Physics(unittest.TestCase):
    def test_targets_of_a_controller_give_its_motion(self):
        """A controller whose responses all have one time constant, replayed from outside, in every model."""
        for options in (
            {"problem": "star-man-travel"},
            {"problem": "star-man-travel", "joints": "limited"},
            {"problem": "inchworm-travel", "joints": "limited", "ground": "rubble"},
            {"figure": "walking-table", "ground": "stairs"},
        ):
            document = gaitsmith.document(**options, duration=3, search="rgt", evaluations=30)
            actuator = "length_1" if "nodes" in document["figure"] else "theta_1"
            document["senses"].update(tau_min_s=0.2, tau_max_s=0.2)
            document["pushes"] = [{"step": 50, "endpoint": 1, "impulse_x_ns": 2.0, "impulse_y_ns": 1.0}]
            document["environment"].update(sway_rad=0.1, sway_period_s=1.0)
            document = gaitsmith.synthesize(document)
            motion, targets = gaitsmith.simulate(document), gaitsmith.decisions(document)["target"]
            for observation in ("senses", "state"):
                env = vector(document, 2, observation, tau=0.2)
                env.reset()
                total = 0.0
                for step in range(300):
                    seen, rewards, terminated, truncated, infos = env.step(np.tile(targets[step], (2, 1)))
                    total += rewards[1]
                    self.assertEqual(infos["travel"][1], motion["x"][step + 1])
                    if observation == "state":
                        named = dict(zip(env.observation_names, seen[0]))
                        self.assertEqual(named[actuator], np.float32(motion[actuator][step + 1]))
                        self.assertEqual(named["vy"], np.float32(motion["vy"][step + 1]))
                        self.assertEqual(named["touch_1"], motion["fn1"][step + 1] > 0)
                        np.testing.assert_allclose(named["turn_sine"], np.sin(motion["phi"][step + 1]), atol=1e-6)
                        rate = (motion["phi"][step + 1] - motion["phi"][step]) / 0.01
                        np.testing.assert_allclose(named["turn_rate"], rate, rtol=1e-4, atol=1e-4)
                self.assertTrue(truncated.all())
                np.testing.assert_allclose(total, abs(motion.terms["travel"]), rtol=1e-12)
                if observation == "senses":
                    np.testing.assert_array_equal(seen[0], gaitsmith.decisions(document)["senses"][-1])

    def test_rewards_add_up_to_the_primary_term(self):
        for task in ("travel", "travel-left", "jump"):
            env = vector(gaitsmith.document(problem="star-man-travel", task=task, duration=1), 4, "state")
            env.reset()
            env.action_space.seed(2)
            total, heights = np.zeros(4), []
            for _ in range(100):
                seen, rewards, _, _, infos = env.step(env.action_space.sample())
                total += rewards
                heights.append(seen[:, env.observation_names.index("y")])
            expected = {"travel": np.abs(infos["travel"]), "travel-left": -infos["travel"]}.get(task)
            if expected is None:
                start = env.reset()[0][:, env.observation_names.index("y")]
                expected = np.maximum(np.max(heights, axis=0), start) - start
            np.testing.assert_allclose(total, expected, atol=1e-6)

    def test_frame_skip_is_as_many_steps(self):
        one, five = vector(short(), 1), vector(short(), 1, frame_skip=5)
        one.reset(), five.reset()
        for _ in range(4):
            action = one.action_space.sample()
            gained = 0.0
            for _ in range(5):
                seen = one.step(action)
                gained += seen[1][0]
            skipped = five.step(action)
            np.testing.assert_array_equal(seen[0], skipped[0])
            np.testing.assert_allclose(skipped[1][0], gained, atol=1e-12)
        self.assertTrue(skipped[3].all())

    def test_timer_is_sensed(self):
        env = vector(gaitsmith.document(problem="star-man-travel", sense="timer=0.1"), 1)
        self.assertEqual(env.observation_names, ["timer"])
        self.assertEqual(env.reset()[0][0, 0], 0.0)
        seen = [round(float(env.step(env.action_space.sample())[0][0, 0]), 3) for _ in range(11)]
        self.assertEqual(seen, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.0, 0.1])


class Boxes(unittest.TestCase):
    def test_box(self):
        box = OwnBox([-1, 0], [1, np.inf], dtype=np.float32, seed=1)
        self.assertEqual(box.shape, (2,))
        for _ in range(100):
            self.assertIn(box.sample(), box)
        self.assertEqual(box.sample().dtype, np.float32)
        for wrong in ([2, 0], [0, -1], [0], [np.nan, 0], np.zeros(2, dtype=np.float64)):
            self.assertNotIn(np.asarray(wrong) if isinstance(wrong, np.ndarray) else np.asarray(wrong, np.float32), box)
        box.seed(3)
        first = box.sample()
        box.seed(3)
        np.testing.assert_array_equal(box.sample(), first)
        self.assertEqual(box, OwnBox([-1, 0], [1, np.inf]))
        self.assertNotEqual(box, OwnBox([-1, 0], [1, 2]))


if __name__ == "__main__":
    unittest.main()
