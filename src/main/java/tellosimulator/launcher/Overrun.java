package tellosimulator.launcher;

/** The limit because of which a program was killed. */
public enum Overrun {
  TIME,
  OUTPUT,
  MEMORY,
  PROCESSES
}
