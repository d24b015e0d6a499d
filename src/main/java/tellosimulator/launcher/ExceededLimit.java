package tellosimulator.launcher;

/** The limit because of which a program was killed. */
public enum ExceededLimit {
  TIME,
  OUTPUT,
  MEMORY,
  PROCESSES
}
