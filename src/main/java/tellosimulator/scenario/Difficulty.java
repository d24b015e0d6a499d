package tellosimulator.scenario;

/** The programming skill that a scenario requires. */
public enum Difficulty {
  EASY,
  MEDIUM,
  HARD
}
