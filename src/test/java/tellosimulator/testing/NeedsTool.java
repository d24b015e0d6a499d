package tellosimulator.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Declares the external programs that a test starts. If one of them is missing the test is skipped,
 * with the command that installs it; with {@code CI=true} in the environment, it fails instead.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Tag("process")
@ExtendWith(ToolCondition.class)
public @interface NeedsTool {

  /** The programs, all of which must be available. */
  Tool[] value();
}
