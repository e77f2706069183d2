! One arch as exact text, a question that makes no sense, and many arches as doubles.
!
!     gfortran target/c/include/couplet_c.f90 arches.f90 -L target/c/lib -lcouplet_c -Wl,-rpath,target/c/lib -o arches
program arches
  use couplet_c
  implicit none
  integer(c_size_t), parameter :: n = 5
  character(kind=c_char, len=*), parameter :: weight = "milankovitch" // c_null_char
  type(c_ptr) :: answer
  real(c_double) :: value, lower, upper
  real(c_double), parameter :: half_opening(n) = [0.5d0, 1.375d0, 1.375d0, 2.4375d0, 4.0d0]
  real(c_double), parameter :: friction(n) = [0.5d0, 0.0625d0, 0.25d0, 1.375d0, 0.5d0]
  integer(c_int8_t) :: verdict(n), mode(n)
  real(c_double) :: values(n, 3, 2)
  integer :: i

  ! The least thickness, to 40 digits, and its bounds as doubles.
  if (couplet_state(weight, "80deg" // c_null_char, "0.25" // c_null_char, 40_c_size_t, answer) /= couplet_proved) then
    error stop "not proved"
  end if
  if (couplet_double(answer, "thickness" // c_null_char, value, lower, upper) /= couplet_proved) error stop "no thickness"
  if (.not. (lower <= value .and. value <= upper .and. lower < upper)) error stop "the bounds are no bounds"
  print '(a,1x,a)', couplet_string(couplet_mode(answer)), &
    couplet_string(couplet_text(answer, "thickness" // c_null_char, couplet_value))
  call couplet_free(answer)

  ! What makes no sense has a sentence.
  if (couplet_state(weight, "4" // c_null_char, "0.25" // c_null_char, 40_c_size_t, answer) /= couplet_usage) then
    error stop "not refused"
  end if
  print '(a)', couplet_string(couplet_reason(answer))
  call couplet_free(answer)

  ! Many arches: a row that makes no sense is a row.
  if (couplet_states(weight, n, half_opening, friction, c_null_ptr, "thickness,thrust" // c_null_char, 1_c_size_t, verdict, &
      mode, values, answer) /= couplet_open) error stop "every row is decided"
  call couplet_free(answer)
  do i = 1, int(n)
    if (verdict(i) == couplet_stands) then
      print '(i0,1x,a,2(1x,z16.16))', verdict(i), couplet_string(couplet_mode_name(int(mode(i), c_int))), &
        values(i, 1, 1), values(i, 1, 2)
    else
      print '(i0,1x,a)', verdict(i), couplet_string(couplet_mode_name(int(mode(i), c_int)))
    end if
  end do
end program
