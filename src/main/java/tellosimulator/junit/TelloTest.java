package tellosimulator.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test, or a class of tests, with simulated drones. Tests and their lifecycle methods may have
 * parameters of type {@link SimulatedDrone}, {@link TelloSimulation} and {@link TelloSimulator}.
 *
 * <p>A class has one simulator, which begins anew before each test; tests of the class run one
 * after another, however JUnit is told to run them. On a method it makes a test of it, with a
 * simulator of its own and nothing of what the class says.
 *
 * <p>A test fails, too, when a drone crashed or the scenario's goals were missed after a takeoff,
 * unless {@link #onCrash} says otherwise.
 */
@Documented
@Inherited
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.METHOD})
@Test
@ExtendWith(TelloSimulatorExtension.class)
public @interface TelloTest {

  /** A file, or one of the scenarios that come with the program; empty for an empty room. */
  String scenario() default "";

  /** How many drones, where no scenario says it; 0 for one. */
  int drones() default 0;

  /** {@code edu}, {@code tello} or {@code tt}; empty for what the scenario says. */
  String profile() default "";

  /** {@code report} or {@code measured}; empty for what the scenario says. */
  String behavior() default "";

  /** Simulated seconds in a second of the wall clock, or {@code max}. */
  String timeFactor() default "max";

  /** Of everything random; 0 for what the scenario says. */
  long seed() default 0;

  /** {@code ideal}, {@code lab}, {@code classroom} or {@code crowded}; empty for the usual one. */
  String link() default "";

  /** What goes wrong, such as {@code "loss state 20% at 5s for 10s"}. */
  String[] faults() default {};

  /** Whether drones film after {@code streamon}. */
  boolean video() default true;

  /** Which ports are used. */
  PortChoice ports() default PortChoice.FREE;

  /** What becomes of a test whose drone crashed, or missed its goals, though it asserts nothing. */
  OnCrash onCrash() default OnCrash.FAIL;
}
