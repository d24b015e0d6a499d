package tellosimulator.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test that starts programs of others. Where one of them is missing the test is skipped, with the
 * command that installs it; where the environment says {@code CI=true}, that is a failure.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@Tag("process")
@ExtendWith(ToolCondition.class)
public @interface NeedsTool {

  /** The programs, all of which must be there. */
  Tool[] value();
}
