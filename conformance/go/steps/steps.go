// Package steps tells the runner each command and its reply, and how to judge them; see steps.py.
package steps

import (
	"bufio"
	"encoding/json"
	"fmt"
	"os"
	"time"
)

// Pose is what the drone's core says: cm in the room, yaw in degrees clockwise.
type Pose struct{ X, Y, Z, Yaw float64 }

// Step is a command with its reply, and one of the expectations.
type Step struct {
	Command string   `json:"command"`
	Reply   string   `json:"reply"`
	Want    *string  `json:"want,omitempty"`
	Least   *float64 `json:"least,omitempty"`
	Near    []any    `json:"near,omitempty"`
	Free    *Free    `json:"free,omitempty"`
}

// Free is how far a command leads if that is not known to the centimetre.
type Free struct {
	Direction string  `json:"direction"`
	Least     float64 `json:"least"`
	Most      float64 `json:"most"`
	Aside     float64 `json:"aside"`
}

// Drift is how far a drone that behaves as measured may move aside [cm].
const Drift = 40

var input = bufio.NewReader(os.Stdin)

// Report reports a step, and returns where the drone is.
func Report(step Step) Pose {
	line, _ := json.Marshal(step)
	fmt.Println("step " + string(line))
	answer, err := input.ReadBytes('\n')
	if err != nil {
		fmt.Println("the runner is gone")
		os.Exit(1)
	}
	var pose Pose
	_ = json.Unmarshal(answer, &pose)
	return pose
}

// Moved reports a move in some direction that is between two distances [cm].
func Moved(command, direction string, least, most float64) Pose {
	none := ""
	return Report(Step{Command: command, Want: &none, Free: &Free{direction, least, most, Drift}})
}

// Holds reports whether something is so.
func Holds(command string, value any, want string) Pose {
	return Report(Step{Command: command, Reply: fmt.Sprint(value), Want: &want})
}

// Least reports a number that must be at least so large.
func Least(command string, value, least float64) Pose {
	return Report(Step{Command: command, Reply: fmt.Sprint(value), Least: &least})
}

// Near reports a number that must be near another one.
func Near(command string, value, wanted, tolerance float64) Pose {
	return Report(Step{Command: command, Reply: fmt.Sprint(value), Near: []any{wanted, tolerance}})
}

// Await waits until something holds, but not longer than some seconds.
func Await(holds func() bool, seconds float64) bool {
	end := time.Now().Add(time.Duration(seconds * float64(time.Second)))
	for !holds() && time.Now().Before(end) {
		time.Sleep(50 * time.Millisecond)
	}
	return holds()
}
