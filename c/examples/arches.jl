# One arch as exact text, a question that makes no sense, and many arches as doubles.
#
#     LD_LIBRARY_PATH=target/c/lib julia arches.jl

const couplet = "libcouplet_c"

"What a function makes of an answer; then the answer is freed."
function asked(read, ask)
    answer = Ref{Ptr{Cvoid}}(C_NULL)
    code = ask(answer)
    try
        return read(code, answer[])
    finally
        ccall((:couplet_free, couplet), Cvoid, (Ptr{Cvoid},), answer[])
    end
end

state(half_opening, friction, digits) = answer -> ccall((:couplet_state, couplet), Cint,
    (Cstring, Cstring, Cstring, Csize_t, Ref{Ptr{Cvoid}}), "milankovitch", half_opening, friction, digits, answer)
mode(answer) = unsafe_string(ccall((:couplet_mode, couplet), Cstring, (Ptr{Cvoid},), answer))
reason(answer) = unsafe_string(ccall((:couplet_reason, couplet), Cstring, (Ptr{Cvoid},), answer))
text(answer, quantity) =
    unsafe_string(ccall((:couplet_text, couplet), Cstring, (Ptr{Cvoid}, Cstring, Cint), answer, quantity, 0))
mode_name(code) = unsafe_string(ccall((:couplet_mode_name, couplet), Cstring, (Cint,), code))

# The least thickness, to 40 digits.
asked(state("80deg", "0.25", 40)) do code, answer
    code == 0 || error(reason(answer))
    println(mode(answer), " ", text(answer, "thickness"))
end

# What makes no sense has a sentence.
asked(state("4", "0.25", 40)) do code, answer
    @assert code == 2
    println(reason(answer))
end

# Many arches: a row that makes no sense is a row.
half_opening = [0.5, 1.375, 1.375, 2.4375, 4.0]
friction = [0.5, 0.0625, 0.25, 1.375, 0.5]
n = length(half_opening)
verdict, modes, values = zeros(UInt8, n), zeros(UInt8, n), zeros(n, 3, 2)
code = ccall((:couplet_states, couplet), Cint,
    (Cstring, Csize_t, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Cstring, Csize_t, Ptr{UInt8}, Ptr{UInt8}, Ptr{Float64},
     Ptr{Cvoid}),
    "milankovitch", n, half_opening, friction, C_NULL, "thickness,thrust", 1, verdict, modes, values, C_NULL)
@assert code == 1
bits(x) = string(reinterpret(UInt64, x), base = 16, pad = 16)
for i in 1:n
    proved = verdict[i] == 0 ? string(" ", bits(values[i, 1, 1]), " ", bits(values[i, 1, 2])) : ""
    println(Int(verdict[i]), " ", mode_name(modes[i]), proved)
end
