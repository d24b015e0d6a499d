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
 * Marks a test, or a class of tests, that uses simulated drones. Tests and their lifecycle methods
 * may have parameters of type {@link SimulatedDrone}, {@link TelloSimulation} and {@link
 * TelloSimulator}.
 *
 * <p>A class has one simulator, which is reset before each test. Tests of the class run one after
 * another, even if JUnit is configured to run tests in parallel. On a method, this annotation
 * declares a test with its own simulator, and completely replaces the settings of the class.
 *
 * <p>A test also fails if a drone crashed, or if a drone took off and the scenario's goals were
 * missed, unless {@link #onCrash} allows this.
 */
@Documented
@Inherited
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.METHOD})
@Test
@ExtendWith(TelloSimulatorExtension.class)
public @interface TelloTest {

  /** The scenario: a file, or one of those that come with the program; empty for an empty room. */
  String scenario() default "";

  /** The number of drones, allowed only without a scenario; 0 for the default, one drone. */
  int drones() default 0;

  /** The product: {@code edu}, {@code tello} or {@code tt}; empty for that of the scenario. */
  String profile() default "";

  /** The reference model: {@code report} or {@code measured}; empty for that of the scenario. */
  String behavior() default "";

  /** The number of simulated seconds per second of wall clock time, or {@code max}. */
  String timeFactor() default "max";

  /** The seed of all randomness; 0 for the seed of the scenario. */
  long seed() default 0;

  /**
   * The link quality: {@code ideal}, {@code lab}, {@code classroom} or {@code crowded}; empty for
   * the default.
   */
  String link() default "";

  /** The faults, such as {@code "loss state 20% at 5s for 10s"}. */
  String[] faults() default {};

  /** Whether drones send video after {@code streamon}. */
  boolean video() default true;

  /** The ports to use. */
  PortChoice ports() default PortChoice.FREE;

  /**
   * Whether a test fails if it passes its own assertions, but a drone crashed or the goals were
   * missed.
   */
  OnCrash onCrash() default OnCrash.FAIL;
}
