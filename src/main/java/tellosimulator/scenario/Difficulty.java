package tellosimulator.scenario;

/** How much a scenario asks of who programs for it. */
public enum Difficulty {
  EASY,
  MEDIUM,
  HARD
}
